// Drawing on several threads when nobody listens: every thread draws all triangles in order, but
// only its own band of rows. A pixel meets the same fragments in the same order as on one thread,
// so the picture is the same to the bit.
//
// Sort-middle in the classification of Molnar, Cox, Ellsworth and Fuchs, A Sorting Classification
// of Parallel Rendering, 1994; differs: there is no sorting, a thread skips what misses its band.
#pragma once

#include "core/pipeline/frame.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace hs::pipeline {

/// Bands of whole rows from the top, one per thread, of about the same cost to draw; some may be
/// empty. Precondition: the vertex stage has run.
std::vector<PixelRect> balanced_bands(const Frame& frame, unsigned threads);

/// Whether a triangle that needs no clipping cannot cover a pixel of the band. Costs three
/// comparisons; what it lets pass may still miss. A row reaches half a pixel beyond its centers:
/// samples lie there.
[[nodiscard]] inline bool
misses(const PixelRect& band, const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c) {
    if ((a.outcode | b.outcode | c.outcode) != 0) {
        return false;
    }
    const auto [top, bottom] = std::minmax({a.window.fixed.y, b.window.fixed.y, c.window.fixed.y});
    constexpr int reach = subpixel_scale / 2;
    return bottom < band.y0 * subpixel_scale - reach ||
           top > (band.y1 - 1) * subpixel_scale + reach;
}

} // namespace hs::pipeline
