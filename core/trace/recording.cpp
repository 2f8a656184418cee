#include "core/trace/recording.hpp"

#include "core/base/hash.hpp"
#include "core/pipeline/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hs::trace {

std::uint32_t Recording::object_of_triangle(std::uint32_t triangle) const {
    HS_DCHECK(triangle < triangles.size(), "a triangle of this frame");
    const auto after = std::upper_bound(
        objects.begin(),
        objects.end(),
        triangle,
        [](std::uint32_t t, const ObjectRange& object) { return t < object.first_triangle; }
    );
    // Objects without triangles share their first number with the next object, which is the one
    // meant
    return static_cast<std::uint32_t>(after - objects.begin()) - 1;
}

std::vector<std::uint32_t> Recording::draws_of_triangle(std::uint32_t triangle) const {
    if (order.parts.empty()) {
        return {triangles[triangle].last_draw};
    }
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i <= triangles[triangle].last_draw; ++i) {
        if (triangle_of_draw(order.draws[i]) == triangle) {
            found.push_back(i);
        }
    }
    return found;
}

std::uint32_t Recording::draw_of_step(StepId step) const {
    HS_DCHECK(step >= first_triangle_step && step < end_step, "a step of the triangle stages");
    const auto after = std::upper_bound(draw_steps.begin(), draw_steps.end(), step);
    return static_cast<std::uint32_t>(after - draw_steps.begin()) - 1;
}

std::uint32_t Recording::first_row_draw() const {
    const auto triangles_first = [](const pipeline::Draw& draw) { return draw.row < 0; };
    const auto first =
        std::partition_point(order.draws.begin(), order.draws.end(), triangles_first);
    return static_cast<std::uint32_t>(first - order.draws.begin());
}

const Run& Recording::run_of_fragment(std::uint32_t fragment) const {
    HS_DCHECK(fragment < fragments.size(), "a fragment of this frame");
    const auto after =
        std::upper_bound(runs.begin(), runs.end(), fragment, [](std::uint32_t f, const Run& run) {
            return f < run.first_fragment;
        });
    return *(after - 1);
}

std::size_t Recording::bytes() const {
    std::size_t total = fragments.bytes() + color32f.bytes() + samples.bytes();
    total += triangles.capacity() * sizeof(TriangleRecord);
    total += order.draws.capacity() * (sizeof(pipeline::Draw) + sizeof(StepId));
    total += order.parts.capacity() * sizeof(pipeline::TrianglePart);
    total += order.polygons.capacity() * sizeof(pipeline::OrderedPolygon);
    total += order.sweep ? order.sweep->bytes() : 0;
    total += decisions.size() == 0 ? 0 : decisions.bytes();
    total += runs.capacity() * sizeof(Run) + index.capacity() * sizeof(IndexEntry);
    std::vector<const PixelBuffer*> buffers{&final_pixels};
    for (const Checkpoint& checkpoint : checkpoints) {
        buffers.push_back(&checkpoint.buffer);
    }
    return total + PixelBuffer::bytes_together(buffers);
}

namespace {

void add_color(Digest& digest, const PixelBuffer& pixels, PixelPos p) {
    if (!pixels.float_color()) {
        digest.add(pixels[p].color);
        return;
    }
    const glm::vec4 color = pixels.color(p);
    for (const float channel : {color.r, color.g, color.b, color.a}) {
        digest.add(channel);
    }
}

} // namespace

std::uint64_t Recording::digest() const {
    Digest digest;
    for (int y = 0; y < height(); ++y) {
        for (int x = 0; x < width(); ++x) {
            add_color(digest, final_pixels, {x, y});
            digest.add(final_pixels[{x, y}].depth);
            if (samples.active()) {
                const std::uint32_t last = final_pixels[{x, y}].last_fragment;
                framebuffer::add_samples(digest, samples.after(last), settings().color_format);
            }
        }
    }
    return digest.value();
}

std::string
primitive_path(const Recording& recording, std::uint32_t object, std::uint32_t triangle) {
    const scene::Primitive primitive = recording.frame->calls()[object].primitive(triangle);
    return fmt::format("object {} / {} {}", object, name_of(primitive.kind), primitive.number);
}

} // namespace hs::trace
