// Traversals: which pixels of the image a triangle is asked about, and in which order.
//
// All share one signature, narrate every question they ask, and emit the same fragments. Their work
// comes in *units* (a row, later a tile) so that a playhead can re-run a few of them instead of a
// whole large triangle.
#pragma once

#include "core/base/pixel.hpp"
#include "core/raster/edge_function.hpp"
#include "core/raster/triangle_setup.hpp"
#include "core/scene/settings.hpp"

#include <algorithm>
#include <limits>

namespace hs::raster {

/// Units [first, last) of a traversal, counted from its beginning. The default is all of them.
struct UnitRange {
    int first = 0;
    int last = std::numeric_limits<int>::max();
};

/// What a traversal says: a unit begins; a pixel was asked, with these values, and is inside or
/// not.
template <typename T>
concept TraversalTrace = requires(T trace, int unit, PixelPos pixel, const EdgeValues& values) {
    trace.unit(unit);
    trace.edge_test(pixel, values, true);
};

/// Visits every pixel of `region` row by row: the loop that brute force and bounding box share, so
/// that they differ in nothing but the region. Unit k is row y0 + k. `emit(pixel, edge values)` is
/// called for every covered pixel.
template <TraversalTrace Trace, typename Emit>
void visit_rows(
    const TriangleSetup& setup, const PixelRect& region, UnitRange units, Trace& trace, Emit&& emit
) {
    const int last = std::min(units.last, region.height());
    for (int unit = units.first; unit < last; ++unit) {
        trace.unit(unit);
        for (int x = region.x0; x < region.x1; ++x) {
            const PixelPos pixel{x, region.y0 + unit};
            const EdgeValues values = setup.evaluate(pixel);
            const bool inside = setup.covers(values);
            trace.edge_test(pixel, values, inside);
            if (inside) {
                emit(pixel, values);
            }
        }
    }
}

} // namespace hs::raster
