// Derivatives of what is interpolated, as differences within a block of 2 × 2 pixels.
//
// OpenGL Shading Language 4.60, section 8.14.1 (dFdx, dFdy): graphics hardware shades fragments
// four at a time, so that each finds its neighbors' values beside its own. Pixels of the block that
// the triangle does not cover run all the same, as *helpers*: the triangle's plane is continued to
// their centers, and nothing of them is ever tested or written. "Coarse" takes one difference for
// the whole block, "fine" that of the fragment's own row and column.
#pragma once

#include "core/raster/interpolation.hpp"

#include <array>

namespace hs::raster {

/// Four neighbors, row by row: (0, 0), (1, 0), (0, 1), (1, 1) from the origin.
struct FragmentQuad {
    PixelPos origin; ///< both coordinates are even
    std::array<Fragment, 4> fragments{};
    std::array<bool, 4> helper{};

    [[nodiscard]] PixelPos pixel(int index) const {
        return {origin.x + index % 2, origin.y + index / 2};
    }
    /// Precondition: the pixel is one of the four.
    [[nodiscard]] int index(PixelPos p) const { return (p.y - origin.y) * 2 + (p.x - origin.x); }
};

/// The block a pixel belongs to: every pixel of the image belongs to one.
[[nodiscard]] inline PixelPos quad_origin(PixelPos p) {
    return {p.x - p.x % 2, p.y - p.y % 2};
}

/// All four pixels interpolated at their centers. `covers(pixel)` tells fragments from helpers.
template <typename Covers>
[[nodiscard]] FragmentQuad make_quad(
    const TriangleSetup& setup, const Interpolator& interpolator, PixelPos pixel, Covers&& covers
) {
    FragmentQuad quad;
    quad.origin = quad_origin(pixel);
    for (int i = 0; i < 4; ++i) {
        const auto at = static_cast<unsigned>(i);
        const PixelPos p = quad.pixel(i);
        quad.fragments[at] = place_fragment(interpolator, setup, p, setup.evaluate(p));
        interpolate_varyings(interpolator, quad.fragments[at]);
        quad.helper[at] = !covers(p);
    }
    return quad;
}

/// Of every varying and of the depth, per pixel to the right (x) and down (y).
struct Derivatives {
    math::Varyings ddx;
    math::Varyings ddy;
    float depth_ddx = 0.0F;
    float depth_ddy = 0.0F;
};

namespace detail {

[[nodiscard]] inline math::Varyings
difference(const math::Varyings& to, const math::Varyings& from) {
    math::Varyings result;
    for (int i = 0; i < math::max_varyings; ++i) {
        result[i] = to[i] - from[i];
    }
    return result;
}

[[nodiscard]] inline Derivatives
differences(const FragmentQuad& quad, unsigned row, unsigned column) {
    const Fragment& left = quad.fragments[2 * row];
    const Fragment& right = quad.fragments[2 * row + 1];
    const Fragment& top = quad.fragments[column];
    const Fragment& bottom = quad.fragments[column + 2];
    return {
        .ddx = difference(right.varyings, left.varyings),
        .ddy = difference(bottom.varyings, top.varyings),
        .depth_ddx = right.depth - left.depth,
        .depth_ddy = bottom.depth - top.depth};
}

} // namespace detail

/// One for the whole block: its first row and first column.
[[nodiscard]] inline Derivatives coarse_derivatives(const FragmentQuad& quad) {
    return detail::differences(quad, 0, 0);
}

/// Of the row and the column a pixel stands in.
[[nodiscard]] inline Derivatives fine_derivatives(const FragmentQuad& quad, PixelPos pixel) {
    const auto index = static_cast<unsigned>(quad.index(pixel));
    return detail::differences(quad, index / 2, index % 2);
}

} // namespace hs::raster
