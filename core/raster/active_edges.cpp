#include "core/raster/active_edges.hpp"

#include <span>

namespace hs::raster {
namespace {

/// The order along a scanline: by x, then by slope. The whole part of x decides exactly; the rest
/// is for people.
bool left_of(const ScanEdge& a, const ScanEdge& b) {
    if (a.x != b.x) {
        return a.x < b.x;
    }
    return a.position() != b.position() ? a.position() < b.position() : a.slope() < b.slope();
}

/// By bucket, then along its scanline.
bool earlier(const ScanEdge& a, const ScanEdge& b) {
    return a.first_row != b.first_row ? a.first_row < b.first_row : left_of(a, b);
}

/// Puts an edge behind the last one that does not come after it: insertion keeps a short list, that
/// is nearly sorted already, in order.
template <typename Before>
void insert(std::array<ScanEdge, 3>& edges, int& count, const ScanEdge& edge, Before before) {
    auto place = static_cast<unsigned>(count++);
    for (; place > 0 && before(edge, edges[place - 1]); --place) {
        edges[place] = edges[place - 1];
    }
    edges[place] = edge;
}

} // namespace

EdgeTable edge_table(const TriangleSetup& setup) {
    EdgeTable table;
    for (int k = 0; k < 3; ++k) {
        const RowRange rows = rows_of_edge(setup, k);
        if (rows.first < rows.end) {
            insert(table.edges, table.count, scan_edge(setup, k, rows.first), earlier);
        }
    }
    return table;
}

ActiveEdges active_edges_at(const TriangleSetup& setup, int row) {
    ActiveEdges active;
    active.row = row;
    for (int k = 0; k < 3; ++k) {
        const RowRange rows = rows_of_edge(setup, k);
        if (rows.first <= row && row < rows.end) {
            insert(active.edges, active.count, scan_edge(setup, k, row), left_of);
        }
    }
    return active;
}

Cost update_active_edges(ActiveEdges& active, const EdgeTable& table, int row) {
    Cost cost;
    ActiveEdges next;
    next.row = row;
    next.place = table.place;
    for (const ScanEdge& edge :
         std::span{active.edges}.first(static_cast<std::size_t>(active.count))) {
        if (edge.end_row <= row) {
            ++next.left;
            continue;
        }
        ScanEdge moved = edge;
        cost += move_down(moved);
        insert(next.edges, next.count, moved, left_of);
    }
    for (const ScanEdge& edge :
         std::span{table.edges}.first(static_cast<std::size_t>(table.count))) {
        if (edge.first_row == row) {
            ++next.entered;
            insert(next.edges, next.count, edge, left_of);
        }
    }
    active = next;
    return cost;
}

} // namespace hs::raster
