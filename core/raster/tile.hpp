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

struct TileTest {
    PixelPos origin;                     ///< a multiple of the size
    int size = 0;                        ///< pixels a side, before the box cuts it
    PixelRect pixels;                    ///< its part of the bounding box; not empty
    std::array<EdgeValues, 4> corners{}; ///< at the corner pixels' centers: top left and right,
                                         ///< bottom left and right
    TileVerdict verdict = TileVerdict::partial;
};

/// Conservative: a tile that all edges cut, each at other corners, counts as partial although it
/// may lie beside the triangle.
[[nodiscard]] TileVerdict
judge_corners(const TriangleSetup& setup, const std::array<EdgeValues, 4>& corners);

/// Precondition: the tile meets the setup's bounds.
[[nodiscard]] TileTest test_tile(const TriangleSetup& setup, PixelPos origin, int size);

} // namespace hs::raster

namespace hs {
template <>
std::span<const Named<raster::TileVerdict>> names<raster::TileVerdict>();
} // namespace hs
