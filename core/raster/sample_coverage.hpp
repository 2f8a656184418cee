// Coverage by samples: the triangle's three edge functions at several points of a pixel.
//
// An edge function is linear, so at a sample it is its value at the pixel's center plus a constant
// of the triangle. Both are exact integers, and ties go by the top-left rule at every sample as
// they do at centers: triangles that share an edge share no sample and leave none out.
#pragma once

#include "core/raster/sample_pattern.hpp"
#include "core/raster/traversal.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace hs::raster {

/// What each sample adds to E01, E12, E20 at a pixel's center.
struct SampleSteps {
    int count = 1;
    std::array<EdgeValues, max_samples> steps{};

    /// The three edge functions at a sample.
    [[nodiscard]] EdgeValues at(const EdgeValues& center, int sample) const {
        const EdgeValues& step = steps[static_cast<unsigned>(sample)];
        return {center[0] + step[0], center[1] + step[1], center[2] + step[2]};
    }
};

[[nodiscard]] inline SampleSteps sample_steps(const TriangleSetup& setup, int samples) {
    SampleSteps result;
    result.count = samples;
    const std::span<const SampleOffset> pattern = sample_pattern(samples);
    for (std::size_t s = 0; s < pattern.size(); ++s) {
        for (unsigned k = 0; k < 3; ++k) {
            const EdgeFunction& edge = setup.edges[k];
            result.steps[s][k] = edge.a * pattern[s].x + edge.b * pattern[s].y;
        }
    }
    return result;
}

/// A setup that traversals ask at samples. Its bounds are those of `bounds_of_samples`.
struct SampledSetup : TriangleSetup {
    SampleSteps samples;
    TileReach reach;
};

[[nodiscard]] inline SampledSetup at_samples(const TriangleSetup& setup, int samples) {
    SampledSetup result{setup, sample_steps(setup, samples), {}};
    for (unsigned k = 0; k < 3; ++k) {
        const auto steps = std::span{result.samples.steps}.first(static_cast<std::size_t>(samples));
        const auto step = [k](const EdgeValues& sample) { return sample[k]; };
        const auto [least, most] = std::ranges::minmax(steps, {}, step);
        result.reach.in[k] = most[k];
        result.reach.out[k] = least[k];
    }
    return result;
}
[[nodiscard]] inline const TileReach& reach_of(const SampledSetup& setup) {
    return setup.reach;
}

/// Which samples of a pixel the triangle covers.
[[nodiscard]] inline CoverageMask
covered_samples(const TriangleSetup& setup, const SampleSteps& samples, const EdgeValues& center) {
    unsigned mask = 0;
    for (int s = 0; s < samples.count; ++s) {
        mask |= setup.covers(samples.at(center, s)) ? 1U << static_cast<unsigned>(s) : 0U;
    }
    return static_cast<CoverageMask>(mask);
}

/// The pixels that have a sample within the triangle's outermost vertices, clipped to the image.
[[nodiscard]] inline PixelRect
bounds_of_samples(const TriangleSetup& setup, int samples, const PixelRect& image) {
    const std::span<const SampleOffset> pattern = sample_pattern(samples);
    const auto [left, right] = std::ranges::minmax(pattern, {}, &SampleOffset::x);
    const auto [top, bottom] = std::ranges::minmax(pattern, {}, &SampleOffset::y);
    const auto& [v0, v1, v2] = setup.vertices;
    const auto [min_x, max_x] = std::minmax({v0.x, v1.x, v2.x});
    const auto [min_y, max_y] = std::minmax({v0.y, v1.y, v2.y});
    const PixelRect reached{
        first_center_at_or_after(min_x - right.x),
        first_center_at_or_after(min_y - bottom.y),
        end_of_centers_up_to(max_x - left.x),
        end_of_centers_up_to(max_y - top.y)};
    return intersect(reached, image);
}

/// Asks every sample of a pixel whose edge values at the center are known: three additions each.
/// `emit(pixel, edge values at its center, covered samples)` if one is covered.
template <TraversalTrace Trace, typename Emit>
void ask_samples(
    const TriangleSetup& setup,
    const SampleSteps& samples,
    PixelPos pixel,
    const EdgeValues& center,
    Trace& trace,
    Emit&& emit
) {
    unsigned mask = 0;
    for (int s = 0; s < samples.count; ++s) {
        const EdgeValues values = samples.at(center, s);
        const bool inside = setup.covers(values);
        mask |= inside ? 1U << static_cast<unsigned>(s) : 0U;
        trace.cost(cost_of_moving);
        trace.sample_tested({pixel, s, values, inside});
    }
    if (mask != 0) {
        emit(pixel, center, static_cast<CoverageMask>(mask));
    }
}

/// Asks every sample of every pixel of `region`, row by row; unit k is row y0 + k. Cost: the three
/// edge functions at the center, and three additions per sample.
template <TraversalTrace Trace, typename Emit>
void visit_samples(
    const TriangleSetup& setup,
    const SampleSteps& samples,
    const PixelRect& region,
    UnitRange units,
    Trace& trace,
    Emit&& emit
) {
    const int last = std::min(units.last, region.height());
    for (int unit = units.first; unit < last; ++unit) {
        trace.unit(unit);
        for (int x = region.x0; x < region.x1; ++x) {
            const PixelPos pixel{x, region.y0 + unit};
            const EdgeValues center = setup.evaluate(pixel);
            trace.cost(cost_of_asking);
            ask_samples(setup, samples, pixel, center, trace, emit);
        }
    }
}

// What traversals call, for a setup that is asked at samples.

template <TraversalTrace Trace, typename Emit>
void ask(
    const SampledSetup& setup, PixelPos pixel, const EdgeValues& center, Trace& trace, Emit&& emit
) {
    ask_samples(setup, setup.samples, pixel, center, trace, emit);
}

template <typename Emit>
void take(const SampledSetup& setup, PixelPos pixel, const EdgeValues& center, Emit&& emit) {
    emit(
        pixel,
        center,
        static_cast<CoverageMask>((1U << static_cast<unsigned>(setup.samples.count)) - 1U)
    );
}

template <TraversalTrace Trace, typename Emit>
void visit_rows(
    const SampledSetup& setup, const PixelRect& region, UnitRange units, Trace& trace, Emit&& emit
) {
    visit_samples(setup, setup.samples, region, units, trace, emit);
}

} // namespace hs::raster
