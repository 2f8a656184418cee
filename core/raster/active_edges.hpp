// The edge table and the active-edge table of polygon scan conversion.
//
// Foley, van Dam, Feiner and Hughes, Computer Graphics: Principles and Practice, 2nd edition, 1990,
// section 3.6.
#pragma once

#include "core/raster/scan_edge.hpp"

#include <array>

namespace hs::raster {

/// All edges that cross a scanline of the box, in buckets by the first one they cross (those that
/// begin above the box are in its first bucket); a bucket is sorted by x there, then by slope.
/// Horizontal edges are left out: their neighbors bound the spans.
struct EdgeTable {
    std::array<ScanEdge, 3> edges{};
    int count = 0;
    ScanPlace place{}; ///< where its scanlines run
};

/// The edges that cross one scanline, from left to right: they bound the spans in pairs.
struct ActiveEdges {
    int row = 0;
    std::array<ScanEdge, 3> edges{};
    int count = 0;
    int entered = 0; ///< from this scanline's bucket
    int left = 0;    ///< that ended above it
    ScanPlace place{};
};

/// Costs a `cost_of_scan_edge` per edge.
[[nodiscard]] EdgeTable edge_table(const TriangleSetup& setup);

/// The table after the update for `row`, as if the triangle began there: to resume from.
[[nodiscard]] ActiveEdges active_edges_at(const TriangleSetup& setup, int row);

/// Update for the scanline below, of the table's place: drop the edges that have ended, move the
/// others down, enter those of its bucket, sort. Says what moving cost.
Cost update_active_edges(ActiveEdges& active, const EdgeTable& table, int row);

} // namespace hs::raster
