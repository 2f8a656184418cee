// The digital differential analyzer, after Foley, van Dam, Feiner and Hughes, Computer Graphics,
// 1990, section 3.2.1: the coordinate across the line grows by the slope with every step along it,
// and is rounded at each pixel.
//
// Halves round to the larger coordinate, and the sum gathers a rounding error with every addition:
// it takes other pixels than Bresenham's where the ideal line comes that close to the middle
// between two.
#pragma once

#include "core/raster/cost.hpp"
#include "core/raster/line.hpp"
#include "core/raster/traversal.hpp"

#include <cmath>

namespace hs::raster {

/// `emit(pixel)` for every pixel of the line within the region, in order. Steps before the region
/// are added up, too: sums are never taken from the middle.
template <TraversalTrace Trace, typename Emit>
void walk_dda(const LineSetup& line, const PixelRect& region, Trace& trace, const Emit& emit) {
    const int start = line.steep ? line.first.x : line.first.y;
    const float slope = line.steps == 0 ? 0.0F
                                        : static_cast<float>(line.minor_step * line.rise) /
                                              static_cast<float>(line.steps);
    const LineRange range = steps_within(line, region);
    auto sum = static_cast<float>(start);
    int rounded = start;
    for (int k = 0; k <= range.last; ++k) {
        LineStep step{.number = k, .before = static_cast<double>(sum)};
        sum += k > 0 ? slope : 0.0F;
        const int minor = static_cast<int>(std::floor(sum + 0.5F));
        step.moved = minor != rounded;
        rounded = minor;
        step.pixel = line.pixel(k, line.minor_step * (minor - start));
        step.after = static_cast<double>(sum);
        if (k >= range.first && region.contains(step.pixel)) {
            trace.cost({.pixels = 1, .sums = 2}); // the slope, and one half to round
            trace.line_stepped(step);
            emit(step.pixel);
        }
    }
}

} // namespace hs::raster
