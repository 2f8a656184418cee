#include "core/explain/why_color.hpp"

#include "core/explain/value_list.hpp"
#include "core/trace/history.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace hs::explain {
namespace {

using trace::StepKind;

/// The way back, link by link.
class Trail {
public:
    explicit Trail(const trace::Recording& recording) : recording_(recording) {}

    /// Adds a value of a step; false without one of that name.
    bool add(trace::StepId step, std::string_view name) {
        const trace::Step at = trace::describe_step(recording_, step);
        const auto values =
            step_values(recording_, at, trace::step_detail(recording_, at));
        const StepValue* value = find_value(values, name);
        if (value == nullptr) {
            return false;
        }
        links_.push_back({step, trace::step_path(at), *value});
        return true;
    }
    /// Goes from the last link to where its operand of that symbol came from.
    bool follow(std::string_view symbol) {
        for (const ExpressionPtr& operand : operands_of(links_.back().value.expression)) {
            if (operand->symbol == symbol) {
                return go(operand->origin);
            }
        }
        return false;
    }
    /// Goes from the last link to where its first operand with an origin came from.
    bool follow_first() {
        for (const ExpressionPtr& operand : operands_of(links_.back().value.expression)) {
            if (!operand->origin.step.empty()) {
                return go(operand->origin);
            }
        }
        return false;
    }
    /// Returns to a value that an earlier link passed.
    bool branch(const ColorLink& from, std::string_view name) { return add(from.step, name); }

    [[nodiscard]] const ColorLink& last() const { return links_.back(); }
    [[nodiscard]] std::vector<ColorLink> take() { return std::move(links_); }

private:
    bool go(const Origin& origin) {
        const std::optional<Source> source = source_of(recording_, origin);
        return source && add(source->step, source->value);
    }

    const trace::Recording& recording_;
    std::vector<ColorLink> links_;
};

unsigned strongest_channel(const glm::vec4& color) {
    unsigned strongest = 0;
    for (unsigned k = 1; k < 3; ++k) {
        if (color[static_cast<int>(k)] > color[static_cast<int>(strongest)]) {
            strongest = k;
        }
    }
    return strongest;
}

/// The sample that the fragment wrote first; −1 with one sample a pixel.
int sample_of(const trace::Recording& recording, std::uint32_t fragment) {
    int sample = -1;
    for (int s = recording.settings().samples - 1; recording.samples.active() && s >= 0; --s) {
        sample = raster::has_sample(recording.fragments[fragment].passed, s) ? s : sample;
    }
    return sample;
}

unsigned heaviest_vertex(const trace::Recording& recording, std::uint32_t fragment) {
    const auto weights = trace::fragment_detail(recording, fragment).fragment.barycentric_clip;
    unsigned heaviest = 0;
    for (unsigned k = 1; k < 3; ++k) {
        heaviest = weights[k] > weights[heaviest] ? k : heaviest;
    }
    return heaviest;
}

/// From a value before the divide back through clipping to the matrix.
void follow_to_matrix(Trail& trail) {
    constexpr int most = 2 + geometry::max_clip_planes; // cuts are made of cuts
    for (int i = 0; i < most && !trail.last().value.name.starts_with("clip."); ++i) {
        if (!trail.follow_first()) {
            return;
        }
    }
}

} // namespace

std::vector<ColorLink> why_this_color(const trace::Player& player, PixelPos pixel) {
    const trace::Recording& recording = player.recording();
    const std::string channel = channel_names[strongest_channel(player.color(pixel))];
    const std::uint32_t fragment =
        trace::last_writer(recording, player.pixel(pixel).last_fragment, -1, trace::Left::color);
    Trail trail(recording);
    if (fragment == trace::no_fragment) {
        trail.add(0, "pixel color." + channel);
        return trail.take();
    }

    // The color: merged from what shading made of interpolated varyings
    const trace::StepId merge = trace::last_step_of_fragment(recording, fragment);
    const int sample = sample_of(recording, fragment);
    const std::string of = sample < 0 ? std::string{"pixel"} : fmt::format("sample {}", sample);
    trail.add(merge, fmt::format("{} color.{}", of, channel));
    trail.follow(sample < 0 ? "merged." + channel : fmt::format("{} merged.{}", of, channel));
    trail.follow("color." + channel);
    const trace::Step shading = trace::describe_step(recording, trail.last().step);
    trace::Step interpolation = shading;
    interpolation.kind = StepKind::interpolate;
    const auto interpolated = trace::find_step(recording, trace::step_path(interpolation));
    HS_CHECK(static_cast<bool>(interpolated), "what is shaded was interpolated");
    trail.add(*interpolated, "color." + channel);

    // The heaviest vertex: its color, its weight, its place
    const std::string vertex = fmt::format("v{}", heaviest_vertex(recording, fragment));
    const ColorLink mixed = trail.last();
    trail.follow(fmt::format("{}.color.{}", vertex, channel));
    const std::string weight = vertex == "v0" ? "b0" : vertex == "v1" ? "b1" : "b2";
    trail.branch(mixed, weight);
    trace::Step place = interpolation;
    place.kind = StepKind::viewport;
    const auto mapped = trace::find_step(recording, trace::step_path(place));
    if (mapped && trail.add(*mapped, vertex + ".window.x")) {
        trail.follow(vertex + ".ndc.x");
        follow_to_matrix(trail);
    }
    return trail.take();
}

} // namespace hs::explain
