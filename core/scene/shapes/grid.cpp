#include "core/scene/shapes/grid.hpp"

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace hs::scene::shapes {

namespace {

void add_polygon(Mesh& mesh, std::initializer_list<std::uint32_t> corners) {
    mesh.polygon_vertices.insert(mesh.polygon_vertices.end(), corners);
    mesh.polygon_start.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
}

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto& p = mesh.positions;
    if (p[a] != p[b] && p[b] != p[c] && p[c] != p[a]) {
        add_polygon(mesh, {a, b, c});
    }
}

} // namespace

void add_sheet(
    Mesh& mesh, GridSize size, bool quads, const std::function<SurfacePoint(int, int)>& point
) {
    if (mesh.polygon_start.empty()) {
        mesh.polygon_start.push_back(0);
    }
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int row = 0; row <= size.rows; ++row) {
        for (int column = 0; column <= size.columns; ++column) {
            const SurfacePoint p = point(column, row);
            mesh.positions.emplace_back(p.position, 1.0F);
            mesh.normals.push_back(p.normal);
            mesh.uvs.emplace_back(
                static_cast<float>(column) / static_cast<float>(size.columns),
                1.0F - static_cast<float>(row) / static_cast<float>(size.rows)
            );
        }
    }
    const auto stride = static_cast<std::uint32_t>(size.columns) + 1U;
    for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(size.rows); ++row) {
        for (std::uint32_t column = 0; column + 1 < stride; ++column) {
            const std::uint32_t a = first + row * stride + column;
            const std::uint32_t b = a + 1;
            const std::uint32_t c = a + stride + 1;
            const std::uint32_t d = a + stride;
            if (quads) {
                add_polygon(mesh, {a, b, c, d});
            } else {
                add_triangle(mesh, a, b, c);
                add_triangle(mesh, a, c, d);
            }
        }
    }
}

Turn turn(int step, int steps) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(step % steps) / steps;
    return {static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle))};
}

} // namespace hs::scene::shapes
