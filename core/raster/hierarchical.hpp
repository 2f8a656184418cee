// Hierarchical: tiles of the bounding box, each rejected or accepted whole by its corners; those
// that are neither are quartered, and the smallest asked pixel by pixel.
//
// Greene, Hierarchical Polygon Tiling with Coverage Masks, 1996; Seiler et al., Larrabee, 2008,
// section 4.4. Differs: quarters instead of 4 × 4 parts, corners of the tile's own pixels instead
// of the corner each edge prefers. Cost: twelve evaluations per tile, three additions per pixel
// looked at; the inside of a large triangle is filled without a question.
#pragma once

#include "core/raster/edge_steps.hpp"
#include "core/raster/tile.hpp"
#include "core/raster/traversal.hpp"

#include <concepts>

namespace hs::raster {

/// Below this many pixels a side a tile is asked pixel by pixel: its corners would be most of it.
inline constexpr int smallest_tile = 4;

/// `visit(pixel, edge values)` for every pixel of a tile, row by row, starting from the values at
/// its top-left corner.
template <TraversalTrace Trace, typename Visit>
void walk_tile(const TileTest& tile, const EdgeSteps& steps, Trace& trace, Visit&& visit) {
    EdgeValues row = tile.corners[0];
    for (int y = tile.pixels.y0; y < tile.pixels.y1; ++y) {
        EdgeValues values = row;
        for (int x = tile.pixels.x0; x < tile.pixels.x1; ++x) {
            trace.cost({.pixels = 1});
            visit(PixelPos{x, y}, values);
            move(values, steps.right);
            trace.cost(cost_of_moving);
        }
        move(row, steps.down);
        trace.cost(cost_of_moving);
    }
}

template <std::derived_from<TriangleSetup> Setup, TraversalTrace Trace, typename Emit>
void visit_tile(
    const Setup& setup, const EdgeSteps& steps, PixelPos origin, int size, Trace& trace, Emit&& emit
) {
    const TileTest tile = test_tile(setup, origin, size, reach_of(setup));
    trace.cost({.tiles = 1, .evaluations = 12});
    trace.tile_tested(tile);
    if (tile.verdict == TileVerdict::rejected) {
        return;
    }
    if (tile.verdict == TileVerdict::accepted) {
        walk_tile(tile, steps, trace, [&](PixelPos pixel, const EdgeValues& values) {
            take(setup, pixel, values, emit);
        });
    } else if (size <= smallest_tile) {
        walk_tile(tile, steps, trace, [&](PixelPos pixel, const EdgeValues& values) {
            ask(setup, pixel, values, trace, emit);
        });
    } else {
        const int half = size / 2;
        for (const PixelPos corner :
             {origin,
              PixelPos{origin.x + half, origin.y},
              PixelPos{origin.x, origin.y + half},
              PixelPos{origin.x + half, origin.y + half}}) {
            const PixelRect quarter{corner.x, corner.y, corner.x + half, corner.y + half};
            if (!intersect(quarter, setup.bounds).empty()) {
                visit_tile(setup, steps, corner, half, trace, emit);
            }
        }
    }
}

/// Unit k is the k-th tile of `tile_size` that meets the bounding box, row by row.
template <std::derived_from<TriangleSetup> Setup, TraversalTrace Trace, typename Emit>
void traverse_hierarchical(
    int tile_size,
    const Setup& setup,
    const PixelRect& /*image*/,
    UnitRange units,
    Trace& trace,
    Emit&& emit
) {
    const PixelRect& box = setup.bounds;
    if (box.empty()) {
        return;
    }
    const PixelPos first{box.x0 / tile_size, box.y0 / tile_size};
    const int columns = (box.x1 - 1) / tile_size - first.x + 1;
    const int rows = (box.y1 - 1) / tile_size - first.y + 1;
    const EdgeSteps steps = edge_steps(setup);
    const int last = std::min(units.last, columns * rows);
    for (int unit = units.first; unit < last; ++unit) {
        trace.unit(unit);
        const PixelPos tile{first.x + unit % columns, first.y + unit / columns};
        visit_tile(setup, steps, {tile.x * tile_size, tile.y * tile_size}, tile_size, trace, emit);
    }
}

} // namespace hs::raster
