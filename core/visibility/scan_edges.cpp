#include "core/visibility/scan_edges.hpp"

#include <algorithm>
#include <cmath>

namespace hs::visibility {

namespace {

/// Change of x per scanline.
double slope(const ScanEdge& edge) {
    return (edge.bottom.x - edge.top.x) / (edge.bottom.y - edge.top.y);
}

/// The first row of [low, high] whose scanline is at or below y. Compares before converting: a
/// coordinate may be larger than an integer.
int first_scanline(double y, int low, int high) {
    return y <= scanline(low)       ? low
           : y > scanline(high - 1) ? high
                                    : static_cast<int>(std::ceil(y - 0.5));
}

void enter(ScanEdgeTable& table, const ScanEdge& edge) {
    const auto number = static_cast<std::int32_t>(table.edges.size());
    const auto place = [&table](int row) {
        return static_cast<std::size_t>(row - table.first_row);
    };
    table.buckets[place(edge.first_row)].push_back(number);
    for (int row = edge.first_row; row < edge.end_row; ++row) {
        table.crossing[place(row)].push_back(number);
    }
    table.edges.push_back(edge);
}

} // namespace

int first_pixel(double x) {
    return static_cast<int>(std::ceil(x - 0.5));
}

double crossing(const ScanEdge& edge, int row) {
    return edge.top.x + (scanline(row) - edge.top.y) * slope(edge);
}

ScanEdgeTable scan_edge_table(std::span<const WindowPolygon> polygons, int first_row, int end_row) {
    ScanEdgeTable table;
    table.first_row = first_row;
    table.buckets.resize(static_cast<std::size_t>(std::max(end_row - first_row, 0)));
    table.crossing.resize(table.buckets.size());
    for (std::size_t p = 0; p < polygons.size(); ++p) {
        const auto& corners = polygons[p].corners;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::size_t next = (i + 1) % corners.size();
            const bool down = corners[i].position.y <= corners[next].position.y;
            ScanEdge edge{
                .polygon = static_cast<std::int32_t>(p),
                .from = static_cast<std::int32_t>(down ? i : next),
                .to = static_cast<std::int32_t>(down ? next : i)};
            edge.top = glm::dvec2{corners[down ? i : next].position};
            edge.bottom = glm::dvec2{corners[down ? next : i].position};
            edge.first_row = first_scanline(edge.top.y, first_row, end_row);
            edge.end_row = first_scanline(edge.bottom.y, first_row, end_row);
            if (edge.first_row < edge.end_row) {
                enter(table, edge);
            }
        }
    }
    return table;
}

void sort_active(const ScanEdgeTable& table, std::vector<ActiveScanEdge>& active) {
    std::ranges::sort(active, [&](const ActiveScanEdge& a, const ActiveScanEdge& b) {
        if (a.x != b.x) {
            return a.x < b.x;
        }
        const double slope_a = slope(table.edge(a.edge));
        const double slope_b = slope(table.edge(b.edge));
        return slope_a != slope_b ? slope_a < slope_b : a.edge < b.edge;
    });
}

std::vector<ActiveScanEdge> active_edges(const ScanEdgeTable& table, int row) {
    std::vector<ActiveScanEdge> active;
    if (row < table.first_row || row >= table.end_row()) {
        return active;
    }
    for (const std::int32_t edge :
         table.crossing[static_cast<std::size_t>(row - table.first_row)]) {
        active.push_back({edge, 0.0});
    }
    move_active(table, row, active);
    return active;
}

void move_active(const ScanEdgeTable& table, int row, std::vector<ActiveScanEdge>& active) {
    for (ActiveScanEdge& a : active) {
        a.x = crossing(table.edge(a.edge), row);
    }
    sort_active(table, active);
}

} // namespace hs::visibility
