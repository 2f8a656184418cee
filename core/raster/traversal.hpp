// Traversals: which pixels of the image a triangle is asked about, and in which order.
//
// All share one signature, narrate every question they ask, and emit the same fragments. Their work
// comes in *units* (a row, a tile) so that a playhead can re-run a few of them instead of a whole
// large triangle. They ask pixels at their centers, or, given a `SampledSetup`, at several samples
// (sample_coverage.hpp).
#pragma once

#include "core/base/pixel.hpp"
#include "core/raster/active_edges.hpp"
#include "core/raster/cost.hpp"
#include "core/raster/edge_function.hpp"
#include "core/raster/line.hpp"
#include "core/raster/plane_test.hpp"
#include "core/raster/sample_test.hpp"
#include "core/raster/scan_edge.hpp"
#include "core/raster/tile.hpp"
#include "core/raster/triangle_setup.hpp"
#include "core/scene/settings.hpp"

#include <algorithm>
#include <limits>

namespace hs::raster {

/// Units [first, last) of a traversal, counted from its beginning. The default is all of them. A
/// traversal tells of the same steps and the same cost whether it is run whole or unit by unit;
/// what it tells before its first unit, it tells on every run.
struct UnitRange {
    int first = 0;
    int last = std::numeric_limits<int>::max();
};

/// What a traversal says. Calls marked *step* are moments a playhead can stand on.
template <typename T>
concept TraversalTrace = requires(
    T trace,
    int unit,
    PixelPos pixel,
    const EdgeValues& values,
    const Cost& cost,
    const TileTest& tile,
    const EdgeTable& table,
    const ActiveEdges& active,
    const Span& span,
    const PlaneTest& planes,
    const SampleTest& sample,
    const LineStep& line
) {
    trace.unit(unit);                     // a unit begins
    trace.cost(cost);                     // spent since it last said so, toward the next step
    trace.edge_test(pixel, values, true); // *step*: a pixel was asked, and is inside or not
    trace.sample_tested(sample);          // *step*: with several samples, instead of edge_test
    trace.tile_tested(tile);              // *step*: hierarchical
    trace.edges_bucketed(table);          // *step*: edge table, before its first unit
    trace.edges_activated(active);        // *step*: edge table, per scanline
    trace.span_found(span);               // *step*: edge walk and edge table, per scanline
    trace.planes_tested(pixel, planes);   // *step*: homogeneous, per pixel
    trace.line_stepped(line);             // *step*: lines and points, per pixel
};

/// A sink that only counts the pixels asked, not what was found there.
template <typename T>
concept CountingTrace = TraversalTrace<T> && requires(T trace, int pixels) {
    trace.edge_tests(pixels); ///< so many pixels are asked, at the cost of asking each
};

/// A trace that hears nothing; others inherit what they do not listen to.
struct SilentTraversal {
    void unit(int) {}
    void cost(const Cost&) {}
    void edge_test(PixelPos, const EdgeValues&, bool) {}
    void sample_tested(const SampleTest&) {}
    void tile_tested(const TileTest&) {}
    void edges_bucketed(const EdgeTable&) {}
    void edges_activated(const ActiveEdges&) {}
    void span_found(const Span&) {}
    void planes_tested(PixelPos, const PlaneTest&) {}
    void line_stepped(const LineStep&) {}
};
static_assert(TraversalTrace<SilentTraversal>);

/// Asks one pixel: inside all three edges, or not. `emit(pixel, edge values)` if it is.
template <TraversalTrace Trace, typename Emit>
void ask(
    const TriangleSetup& setup, PixelPos pixel, const EdgeValues& values, Trace& trace, Emit&& emit
) {
    const bool inside = setup.covers(values);
    trace.edge_test(pixel, values, inside);
    if (inside) {
        emit(pixel, values);
    }
}

/// Emits a pixel that is known to be covered.
template <typename Emit>
void take(const TriangleSetup& /*setup*/, PixelPos pixel, const EdgeValues& values, Emit&& emit) {
    emit(pixel, values);
}

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
            trace.cost(cost_of_asking);
            const bool inside = setup.covers(values);
            trace.edge_test(pixel, values, inside);
            if (inside) {
                emit(pixel, values);
            }
        }
    }
}

/// The same for a sink that only counts: the same fragments for the same number of questions, but
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
        trace.edge_tests(region.width());
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
        for (; pixel.x < region.x1 && setup.covers(e); next()) {
            emit(pixel, e);
        }
    }
}

} // namespace hs::raster
