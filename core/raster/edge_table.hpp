// Edge table: polygon scan conversion with a table of edges, bucketed by the scanline they begin
// on, and a table of active edges, kept sorted from scanline to scanline. Made for polygons of any
// shape; a triangle never has more than two active edges.
//
// Foley, van Dam, Feiner and Hughes, Computer Graphics: Principles and Practice, 2nd edition, 1990,
// section 3.6. Cost: as the edge walk, plus keeping order.
#pragma once

#include "core/raster/active_edges.hpp"
#include "core/raster/span_fill.hpp"
#include "core/raster/traversal.hpp"

namespace hs::raster {

/// Unit k is the k-th scanline of the triangle.
template <TraversalTrace Trace, typename Emit>
void traverse_edge_table(
    const TriangleSetup& setup,
    const PixelRect& /*image*/,
    UnitRange units,
    Trace& trace,
    Emit&& emit
) {
    if (setup.bounds.empty()) {
        return;
    }

    // Sort the edges into buckets
    const EdgeSteps steps = edge_steps(setup);
    const EdgeTable table = edge_table(setup);
    for (int i = 0; i < table.count; ++i) {
        trace.cost(cost_of_scan_edge);
    }
    trace.edges_bucketed(table);

    // Go down: update the active edges, fill between each pair of them
    const RowRange rows = rows_of_triangle(setup);
    const int last = std::min(units.last, rows.end - rows.first);
    ActiveEdges active;
    if (units.first > 0) {
        active = active_edges_at(setup, rows.first + units.first - 1);
    }
    for (int unit = units.first; unit < last; ++unit) {
        trace.unit(unit);
        const int row = rows.first + unit;
        trace.cost(update_active_edges(active, table, row));
        trace.edges_activated(active);
        for (unsigned i = 0; i + 1 < static_cast<unsigned>(active.count); i += 2) {
            const Span span = span_between(active.edges[i], active.edges[i + 1], row, setup.bounds);
            fill_span(setup, steps, span, trace, emit);
        }
    }
}

} // namespace hs::raster
