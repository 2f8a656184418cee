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

TileVerdict judge_corners(
    const TriangleSetup& setup, const std::array<EdgeValues, 4>& corners, const TileReach& reach
) {
    bool all_inside = true;
    for (unsigned k = 0; k < 3; ++k) {
        bool some_inside = false;
        for (const EdgeValues& corner : corners) {
            const std::int64_t value = corner[k] + setup.top_left_bias[k];
            some_inside = some_inside || value + reach.in[k] >= 0;
            all_inside = all_inside && value + reach.out[k] >= 0;
        }
        if (!some_inside) {
            return TileVerdict::rejected;
        }
    }
    return all_inside ? TileVerdict::accepted : TileVerdict::partial;
}

TileTest test_tile(const TriangleSetup& setup, PixelPos origin, int size, const TileReach& reach) {
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
    tile.reach = reach;
    tile.verdict = judge_corners(setup, tile.corners, reach);
    return tile;
}

} // namespace hs::raster
