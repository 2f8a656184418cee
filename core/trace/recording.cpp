#include "core/trace/recording.hpp"

#include "core/base/hash.hpp"
#include "core/framebuffer/depth.hpp"

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

const Run& Recording::run_of_fragment(std::uint32_t fragment) const {
    HS_DCHECK(fragment < fragments.size(), "a fragment of this frame");
    const auto after =
        std::upper_bound(runs.begin(), runs.end(), fragment, [](std::uint32_t f, const Run& run) {
            return f < run.first_fragment;
        });
    return *(after - 1);
}

std::size_t Recording::bytes() const {
    std::size_t total = fragments.bytes() + color32f.bytes();
    total += triangles.capacity() * sizeof(TriangleRecord);
    total += runs.capacity() * sizeof(Run) + index.capacity() * sizeof(IndexEntry);
    total += last_fragment.capacity() * sizeof(std::uint32_t);
    const auto buffer_bytes = [](const PixelBuffer& buffer) {
        return buffer.pixels.capacity() * sizeof(PixelRecord) +
               buffer.color32f.capacity() * sizeof(glm::vec4);
    };
    for (const Checkpoint& checkpoint : checkpoints) {
        total += buffer_bytes(checkpoint.buffer);
    }
    return total + buffer_bytes(final_pixels);
}

std::uint64_t Recording::digest() const {
    Digest digest;
    for (std::size_t i = 0; i < final_pixels.pixels.size(); ++i) {
        if (final_pixels.color32f.empty()) {
            digest.add(final_pixels.pixels[i].color);
        } else {
            const glm::vec4& color = final_pixels.color32f[i];
            for (const float channel : {color.r, color.g, color.b, color.a}) {
                digest.add(channel);
            }
        }
        digest.add(final_pixels.pixels[i].depth);
    }
    return digest.value();
}

PixelBuffer cleared_pixels(const scene::Settings& settings) {
    PixelBuffer buffer;
    clear_pixels(buffer, settings);
    return buffer;
}

void clear_pixels(PixelBuffer& buffer, const scene::Settings& settings) {
    const std::size_t count =
        static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height);
    PixelRecord clear;
    clear.color = framebuffer::pack(settings.background);
    clear.depth = framebuffer::store_depth(settings.depth_clear(), settings.depth_format);
    buffer.pixels.assign(count, clear);
    if (settings.color_format == scene::ColorFormat::rgba32f) {
        buffer.color32f.assign(count, settings.background);
    }
}

} // namespace hs::trace
