// What several fuzzers claim about results.
#pragma once

#include "core/base/check.hpp"
#include "core/base/diagnostic.hpp"
#include "core/scene/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace hs::fuzz {

/// Every problem is a sentence; its line, if it has one, exists in the text.
inline void check_diagnostics(const Diagnostics& diagnostics, std::string_view text) {
    const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
    HS_CHECK(!diagnostics.empty(), "refused input comes with a reason");
    for (const Diagnostic& d : diagnostics) {
        HS_CHECK(!d.message.empty(), "a reason is a sentence");
        HS_CHECK(d.line >= 0 && d.line <= lines, "a problem stands in the text");
        HS_CHECK(d.column >= 0, "columns count from 1");
    }
}

/// The invariants written at scene::Mesh.
inline void check_mesh(const scene::Mesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    HS_CHECK(mesh.normals.size() == vertices, "a normal for every vertex");
    HS_CHECK(mesh.colors.empty() || mesh.colors.size() == vertices, "a color for every vertex");
    HS_CHECK(mesh.uvs.empty() || mesh.uvs.size() == vertices, "coordinates for every vertex");
    HS_CHECK(mesh.triangle_polygon.size() == mesh.triangles.size(), "a polygon for every triangle");
    for (const glm::vec4& p : mesh.positions) {
        HS_CHECK(
            std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w),
            "positions are finite"
        );
    }
    for (const glm::vec3& n : mesh.normals) {
        HS_CHECK(
            std::isfinite(n.x) && std::isfinite(n.y) && std::isfinite(n.z), "normals are finite"
        );
    }
    for (const scene::TriangleIndices& t : mesh.triangles) {
        HS_CHECK(std::max({t.a, t.b, t.c}) < vertices, "triangles have vertices that exist");
    }
    for (const std::uint32_t polygon : mesh.triangle_polygon) {
        HS_CHECK(polygon < mesh.polygon_count(), "triangles come from polygons that exist");
    }
    for (const std::uint32_t vertex : mesh.polygon_vertices) {
        HS_CHECK(vertex < vertices, "polygons have vertices that exist");
    }
}

} // namespace hs::fuzz
