// Edge walk: down the left and the right side of the triangle at once, filling the span between.
// No pixel outside is ever visited.
//
// Foley, van Dam, Feiner and Hughes, Computer Graphics: Principles and Practice, 2nd edition, 1990,
// section 3.6. Cost: three edges set up, two to four additions per edge and scanline, one
// evaluation of the three edge functions per span, three additions per pixel.
#pragma once

#include "core/base/check.hpp"
#include "core/raster/scan_edge.hpp"
#include "core/raster/span_fill.hpp"
#include "core/raster/traversal.hpp"

namespace hs::raster {

/// The edge on one side of the triangle that crosses a scanline.
/// Precondition: the scanline is one of the triangle's.
[[nodiscard]] inline int edge_on_side(const TriangleSetup& setup, bool left, int row) {
    for (int k = 0; k < 3; ++k) {
        const std::int64_t a = setup.edges[static_cast<unsigned>(k)].a;
        const RowRange rows = rows_of_edge(setup, k);
        if ((left ? a > 0 : a < 0) && rows.first <= row && row < rows.end) {
            return k;
        }
    }
    HS_CHECK(false, "a scanline through a triangle crosses one edge on each side");
    return 0;
}

/// Takes one side's edge from the scanline above to `row`: down along it, or on to the edge that
/// begins here.
template <TraversalTrace Trace>
void follow_side(const TriangleSetup& setup, bool left, int row, ScanEdge& edge, Trace& trace) {
    if (edge.first_row < row && row < edge.end_row) {
        trace.cost(move_down(edge));
    } else {
        edge = scan_edge(setup, edge_on_side(setup, left, row), row);
        trace.cost(cost_of_scan_edge);
    }
}

/// Unit k is the k-th scanline of the triangle.
template <TraversalTrace Trace, typename Emit>
void traverse_edge_walk(
    const TriangleSetup& setup,
    const PixelRect& /*image*/,
    UnitRange units,
    Trace& trace,
    Emit&& emit
) {
    if (setup.bounds.empty()) {
        return;
    }
    const EdgeSteps steps = edge_steps(setup);
    const RowRange rows = rows_of_triangle(setup);
    const int last = std::min(units.last, rows.end - rows.first);
    ScanEdge left;
    ScanEdge right;
    if (units.first > 0 && units.first < last) { // resume: stand on the scanline above
        const int above = rows.first + units.first - 1;
        left = scan_edge(setup, edge_on_side(setup, true, above), above);
        right = scan_edge(setup, edge_on_side(setup, false, above), above);
    }
    for (int unit = units.first; unit < last; ++unit) {
        trace.unit(unit);
        const int row = rows.first + unit;
        follow_side(setup, true, row, left, trace);
        follow_side(setup, false, row, right, trace);
        fill_span(setup, steps, span_between(left, right, row, setup.bounds), trace, emit);
    }
}

} // namespace hs::raster
