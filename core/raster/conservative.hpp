// Conservative overlap: a pixel counts when any part of its square, however small, lies inside the
// triangle.
//
// Akenine-Möller and Aila, Conservative and Tiled Rasterization Using a Modified Triangle Set-Up,
// 2005: an edge function asked at the corner of the square that lies most inside, and the bounding
// box for what the three edges let pass beyond an acute vertex. Differs: exact integers. The square
// reaches half a pixel from its center, so the most inside corner has the center's value plus
// (|a| + |b|) / 2 pixels; that constant stands where the top-left rule keeps its bias, and a
// traversal asks as it always does. Squares that only touch the triangle do not count.
#pragma once

#include "core/raster/triangle_setup.hpp"

#include <algorithm>
#include <cstdlib>

namespace hs::raster {

/// What an edge function gains from a pixel's center to its most inside corner.
[[nodiscard]] inline std::int64_t gain_to_corner(const EdgeFunction& edge) {
    return (std::abs(edge.a) + std::abs(edge.b)) * (subpixel_scale / 2);
}

/// Makes a setup cover the pixels whose squares overlap the triangle, clipped to the image.
inline void widen_to_squares(TriangleSetup& setup, const PixelRect& image) {
    for (unsigned k = 0; k < 3; ++k) {
        setup.top_left_bias[k] = gain_to_corner(setup.edges[k]) - 1; // > 0: touching is not enough
    }
    // Squares whose inside meets the inside of the bounding box
    const auto& [v0, v1, v2] = setup.vertices;
    const auto [min_x, max_x] = std::minmax({v0.x, v1.x, v2.x});
    const auto [min_y, max_y] = std::minmax({v0.y, v1.y, v2.y});
    constexpr std::int32_t nearly_half = subpixel_scale / 2 - 1;
    setup.bounds = intersect(
        {first_center_at_or_after(min_x - nearly_half),
         first_center_at_or_after(min_y - nearly_half),
         end_of_centers_up_to(max_x + nearly_half),
         end_of_centers_up_to(max_y + nearly_half)},
        image
    );
}

} // namespace hs::raster
