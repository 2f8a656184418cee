// The block of 2 × 2 pixels behind a fragment's derivatives, and the helpers a whole piece of a
// triangle needs: found again by interpolating, nothing of it is recorded.
#pragma once

#include "core/math/varyings.hpp"
#include "core/raster/derivatives.hpp"
#include "core/trace/detail.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace hs::trace {

struct QuadDetail {
    raster::FragmentQuad quad;
    math::VaryingLayout layout;
    raster::Derivatives coarse;
    raster::Derivatives fine; ///< of the step's pixel
};

/// Of the step's pixel; `triangle` is the step's. Empty for steps without a pixel, and where a
/// vertex has no place in the window.
std::optional<QuadDetail>
quad_detail(const Recording& recording, const TriangleDetail& triangle, const Step& step);

/// How many pixels a piece covers, and the ones that are shaded only to help them.
struct HelperPixels {
    std::size_t covered = 0;
    std::vector<PixelPos> helpers;
    bool whole = true; ///< false: the piece is too large to be looked through
};

/// Of the step's piece, if its box has no more than `most_pixels`.
HelperPixels helper_pixels(
    const Recording& recording,
    const TriangleDetail& triangle,
    const Step& step,
    std::size_t most_pixels = 65536
);

} // namespace hs::trace
