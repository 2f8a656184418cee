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
                const auto bucket = static_cast<std::size_t>(edge.first_row - first_row);
                table.buckets[bucket].push_back(static_cast<std::int32_t>(table.edges.size()));
                table.edges.push_back(edge);
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
        const double slope_a = slope(table.edges[static_cast<std::size_t>(a.edge)]);
        const double slope_b = slope(table.edges[static_cast<std::size_t>(b.edge)]);
        return slope_a != slope_b ? slope_a < slope_b : a.edge < b.edge;
    });
}

void update_active(const ScanEdgeTable& table, int row, std::vector<ActiveScanEdge>& active) {
    const auto edge_of = [&](const ActiveScanEdge& a) -> const ScanEdge& {
        return table.edges[static_cast<std::size_t>(a.edge)];
    };
    std::erase_if(active, [&](const ActiveScanEdge& a) { return edge_of(a).end_row <= row; });
    for (const std::int32_t edge : table.buckets[static_cast<std::size_t>(row - table.first_row)]) {
        active.push_back({edge, 0.0});
    }
    for (ActiveScanEdge& a : active) {
        a.x = crossing(edge_of(a), row);
    }
    sort_active(table, active);
}

} // namespace hs::visibility
