// Bresenham, Algorithm for Computer Control of a Digital Plotter, 1965: lines with additions of
// whole numbers only.
//
// With n steps along and m across, the error term after pixel k is 2m(k + 1) − 2n·j − n, j being
// the steps taken across so far: twice n times how far the ideal line lies beyond the middle
// between the two pixels to choose from. Positive: move across. Differs: where the line runs
// exactly through that middle (a tie), the pixel with the smaller coordinate is taken whichever way
// the line runs, so that a line and its reverse are the same pixels.
#pragma once

#include "core/raster/cost.hpp"
#include "core/raster/line.hpp"
#include "core/raster/traversal.hpp"

namespace hs::raster {

/// Steps across the line up to step `k`, in closed form: m·k/n rounded, ties as above.
[[nodiscard]] inline int steps_across(const LineSetup& line, int k) {
    if (k < 0 || line.steps == 0) {
        return 0;
    }
    const std::int64_t n = line.steps;
    const std::int64_t tie = line.minor_step < 0 ? n : n - 1;
    return static_cast<int>((2 * std::int64_t{line.rise} * k + tie) / (2 * n));
}

/// Whether an error term asks for a step across.
[[nodiscard]] inline bool moves_across(const LineSetup& line, std::int64_t error) {
    return error > 0 || (error == 0 && line.minor_step < 0);
}

/// `emit(pixel)` for every pixel of the line within the region, in order.
template <TraversalTrace Trace, typename Emit>
void walk_bresenham(
    const LineSetup& line, const PixelRect& region, Trace& trace, const Emit& emit
) {
    const LineRange range = steps_within(line, region);
    const std::int64_t along = 2 * std::int64_t{line.rise};
    const std::int64_t across = 2 * std::int64_t{line.steps};
    int j = steps_across(line, range.first - 1);
    std::int64_t error = along * range.first - across * j - line.steps;
    for (int k = range.first; k <= range.last; ++k) {
        LineStep step{.number = k, .before = static_cast<double>(error)};
        step.moved = k > 0 && moves_across(line, error);
        j += step.moved ? 1 : 0;
        error += step.moved ? along - across : along;
        step.pixel = line.pixel(k, j);
        step.after = static_cast<double>(error);
        if (region.contains(step.pixel)) {
            trace.cost({.pixels = 1, .sums = 1}); // 2m − 2n is known beforehand
            trace.line_stepped(step);
            emit(step.pixel);
        }
    }
}

} // namespace hs::raster
