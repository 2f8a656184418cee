#include "core/visibility/scanline.hpp"

namespace hs::visibility {

ScanState begin_scan(std::vector<WindowPolygon> polygons, int first_row, int end_row) {
    ScanState state;
    const glm::dvec3 extent = reach(std::span<const WindowPolygon>{polygons});
    for (const WindowPolygon& polygon : polygons) {
        state.planes.push_back(plane_of(polygon, extent));
    }
    state.table = scan_edge_table(polygons, first_row, end_row);
    state.row = first_row;
    state.in.resize(polygons.size());
    state.polygons = std::move(polygons);
    return state;
}

bool turn_flag(ScanState& state, std::int32_t polygon) {
    const auto index = static_cast<std::size_t>(polygon);
    state.in[index] = !state.in[index];
    const auto place = std::ranges::lower_bound(state.inside, polygon);
    if (state.in[index]) {
        state.inside.insert(place, polygon);
    } else {
        state.inside.erase(place);
    }
    return state.in[index];
}

double scan_depth(const ScanState& state, std::int32_t polygon, double x) {
    return depth_at(state.planes[static_cast<std::size_t>(polygon)], x, scanline(state.row))
        .value_or(std::numeric_limits<double>::infinity());
}

} // namespace hs::visibility
