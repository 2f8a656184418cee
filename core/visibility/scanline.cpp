#include "core/visibility/scanline.hpp"

namespace hs::visibility {

std::shared_ptr<const ScanScene>
scan_scene(std::vector<WindowPolygon> polygons, int first_row, int end_row) {
    auto scene = std::make_shared<ScanScene>();
    const glm::dvec3 extent = reach(std::span<const WindowPolygon>{polygons});
    for (const WindowPolygon& polygon : polygons) {
        scene->planes.push_back(plane_of(polygon, extent));
    }
    scene->table = scan_edge_table(polygons, first_row, end_row);
    scene->polygons = std::move(polygons);
    return scene;
}

ScanState begin_row(std::shared_ptr<const ScanScene> scene, int row) {
    ScanState state;
    state.row = row;
    state.active = active_edges(scene->table, row - 1);
    state.in.resize(scene->polygons.size());
    state.scene = std::move(scene);
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
    return depth_at(state.scene->planes[static_cast<std::size_t>(polygon)], x, scanline(state.row))
        .value_or(std::numeric_limits<double>::infinity());
}

} // namespace hs::visibility
