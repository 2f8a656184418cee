// The edge table and the active edges of all polygons of a picture, for scanline algorithms.
//
// Wylie, Romney, Evans and Erdahl, Half-Tone Perspective Drawings by Computer, 1967; Foley, van
// Dam, Feiner and Hughes, 1990, section 15.6. Differs: where an edge crosses a scanline is computed
// from its upper end every time, not added up, so any scanline can be the first.
//
// A scanline runs through pixel centers. An edge crosses those from its upper end down to, but not
// at, its lower end; horizontal edges cross none.
#pragma once

#include "core/visibility/plane.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace hs::visibility {

struct ScanEdge {
    std::int32_t polygon = -1;
    std::int32_t from = 0; ///< corner at the upper end
    std::int32_t to = 0;   ///< corner at the lower end
    glm::dvec2 top{0.0};
    glm::dvec2 bottom{0.0};
    int first_row = 0; ///< the first scanline it crosses
    int end_row = 0;   ///< the first below that it does not cross
};

/// Edges of all polygons, those that cross no scanline left out.
struct ScanEdgeTable {
    std::vector<ScanEdge> edges;
    int first_row = 0; ///< of the image; what begins above begins there
    /// Edges in buckets by the first scanline they cross, one per row.
    std::vector<std::vector<std::int32_t>> buckets;
    /// All edges that cross a scanline, one list per row: with them any row can be the first.
    std::vector<std::vector<std::int32_t>> crossing;

    [[nodiscard]] const ScanEdge& edge(std::int32_t i) const {
        return edges[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] const std::vector<std::int32_t>& bucket(int row) const {
        return buckets[static_cast<std::size_t>(row - first_row)];
    }
    [[nodiscard]] int end_row() const { return first_row + static_cast<int>(buckets.size()); }
};

/// An edge that crosses the current scanline, at `x`.
struct ActiveScanEdge {
    std::int32_t edge = -1;
    double x = 0.0;
    friend bool operator==(const ActiveScanEdge&, const ActiveScanEdge&) = default;
};

/// y of the pixel centers of a row.
[[nodiscard]] inline double scanline(int row) {
    return row + 0.5;
}

/// The first pixel whose center is at `x` or right of it.
[[nodiscard]] int first_pixel(double x);

/// Rows `first_row` … `end_row` − 1 of the image.
[[nodiscard]] ScanEdgeTable
scan_edge_table(std::span<const WindowPolygon> polygons, int first_row, int end_row);

/// x of an edge on the scanline of a row.
[[nodiscard]] double crossing(const ScanEdge& edge, int row);

/// From left to right; where edges meet, by slope, then by polygon.
void sort_active(const ScanEdgeTable& table, std::vector<ActiveScanEdge>& active);

/// The active edges of a row, sorted; none where the image does not have it.
[[nodiscard]] std::vector<ActiveScanEdge> active_edges(const ScanEdgeTable& table, int row);

/// Moves all to `row`, then sorts.
void move_active(const ScanEdgeTable& table, int row, std::vector<ActiveScanEdge>& active);

} // namespace hs::visibility
