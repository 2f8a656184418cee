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

/// A sink that only counts the pixels asked, not what was found there.
template <typename T>
concept CountingTrace = TraversalTrace<T> && requires(T trace, int pixels) {
    trace.edge_tests(pixels); ///< so many pixels were asked
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

/// The same for a sink that only counts: the same fragments and the same number of questions, but
/// exact integers are added instead of multiplied. A row of a triangle has pixels outside, then
/// inside, then outside.
template <CountingTrace Trace, typename Emit>
void visit_rows(
    const TriangleSetup& setup, const PixelRect& region, UnitRange units, Trace& trace, Emit&& emit
) {
    const std::int64_t step0 = setup.edges[0].a * subpixel_scale;
    const std::int64_t step1 = setup.edges[1].a * subpixel_scale;
    const std::int64_t step2 = setup.edges[2].a * subpixel_scale;
    const int last = std::min(units.last, region.height());
    for (int unit = units.first; unit < last; ++unit) {
        trace.unit(unit);
        PixelPos pixel{region.x0, region.y0 + unit};
        EdgeValues e = setup.evaluate(pixel);
        const auto next = [&] {
            ++pixel.x;
            e[0] += step0;
            e[1] += step1;
            e[2] += step2;
        };
        while (pixel.x < region.x1 && !setup.covers(e)) {
            next();
        }
        const int first_inside = pixel.x;
        trace.edge_tests(first_inside - region.x0);
        for (; pixel.x < region.x1 && setup.covers(e); next()) {
            trace.edge_tests(1);
            emit(pixel, e);
        }
        trace.edge_tests(region.x1 - pixel.x);
    }
}

} // namespace hs::raster
