// A square of pixels held against a triangle by its corners alone.
//
// Greene, Hierarchical Polygon Tiling with Coverage Masks, 1996; McCormack and McNamara, Tiled
// Polygon Traversal Using Half-Plane Edge Functions, 2000. An edge function is linear, so over the
// pixel centers of a tile it is largest and smallest at corners.
#pragma once

#include "core/base/named.hpp"
#include "core/raster/triangle_setup.hpp"

#include <array>
#include <cstdint>

namespace hs::raster {

enum class TileVerdict : std::uint8_t {
    rejected,
    accepted,
    partial
};

/// What an edge value gains at most from a pixel's center to what is asked there, and at least: 0
/// where centers are asked, else to the samples that lie farthest in and farthest out.
struct TileReach {
    EdgeValues in{};
    EdgeValues out{};
};
[[nodiscard]] inline TileReach reach_of(const TriangleSetup&) {
    return {};
}

struct TileTest {
    PixelPos origin;                     ///< a multiple of the size
    int size = 0;                        ///< pixels a side, before the box cuts it
    PixelRect pixels;                    ///< its part of the bounding box; not empty
    std::array<EdgeValues, 4> corners{}; ///< at the corner pixels' centers: top left and right,
                                         ///< bottom left and right
    TileReach reach;                     ///< from there to what is asked
    TileVerdict verdict = TileVerdict::partial;
};

/// Conservative: a tile that all edges cut, each at other corners, counts as partial although it
/// may lie beside the triangle.
[[nodiscard]] TileVerdict judge_corners(
    const TriangleSetup& setup,
    const std::array<EdgeValues, 4>& corners,
    const TileReach& reach = {}
);

/// Precondition: the tile meets the setup's bounds.
[[nodiscard]] TileTest
test_tile(const TriangleSetup& setup, PixelPos origin, int size, const TileReach& reach = {});

} // namespace hs::raster

namespace hs {
template <>
std::span<const Named<raster::TileVerdict>> names<raster::TileVerdict>();
} // namespace hs
