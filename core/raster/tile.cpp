#include "core/raster/tile.hpp"

namespace hs {

template <>
std::span<const Named<raster::TileVerdict>> names<raster::TileVerdict>() {
    using raster::TileVerdict;
    static constexpr std::array<Named<TileVerdict>, 3> table{{
        {TileVerdict::rejected, "rejected", "all four corners lie outside the same edge"},
        {TileVerdict::accepted, "accepted", "all four corners lie inside all three edges"},
        {TileVerdict::partial, "partial", "the corners do not agree: look closer"},
    }};
    return table;
}

} // namespace hs

namespace hs::raster {

TileVerdict judge_corners(const TriangleSetup& setup, const std::array<EdgeValues, 4>& corners) {
    bool all_inside = true;
    for (unsigned k = 0; k < 3; ++k) {
        int outside = 0;
        for (const EdgeValues& corner : corners) {
            outside += corner[k] + setup.top_left_bias[k] < 0 ? 1 : 0;
        }
        if (outside == 4) {
            return TileVerdict::rejected;
        }
        all_inside = all_inside && outside == 0;
    }
    return all_inside ? TileVerdict::accepted : TileVerdict::partial;
}

TileTest test_tile(const TriangleSetup& setup, PixelPos origin, int size) {
    TileTest tile;
    tile.origin = origin;
    tile.size = size;
    tile.pixels = intersect({origin.x, origin.y, origin.x + size, origin.y + size}, setup.bounds);
    const int right = tile.pixels.x1 - 1;
    const int bottom = tile.pixels.y1 - 1;
    tile.corners = {
        setup.evaluate({tile.pixels.x0, tile.pixels.y0}),
        setup.evaluate({right, tile.pixels.y0}),
        setup.evaluate({tile.pixels.x0, bottom}),
        setup.evaluate({right, bottom}),
    };
    tile.verdict = judge_corners(setup, tile.corners);
    return tile;
}

} // namespace hs::raster
