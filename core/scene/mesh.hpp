// A mesh as the pipeline sees it: vertices, polygons as they were given, and the triangles made
// from them.
#pragma once

#include "core/base/named.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hs::scene {

/// Vertices of one triangle, indices into the mesh.
struct TriangleIndices {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t c = 0; ///< the provoking vertex (OpenGL: the last)

    [[nodiscard]] std::uint32_t operator[](int corner) const {
        return corner == 0 ? a : corner == 1 ? b : c;
    }
    friend bool operator==(const TriangleIndices&, const TriangleIndices&) = default;
};

enum class PrimitiveKind : std::uint8_t {
    triangle,
    line,
    point
};

/// One of a mesh's primitives. A line repeats its second vertex as the third, a point has the same
/// one three times.
struct Primitive {
    PrimitiveKind kind = PrimitiveKind::triangle;
    std::uint32_t number = 0; ///< among its kind
    TriangleIndices vertices;
};

/// Invariants, established by the loaders and `finish_mesh`: every index is in range, every number
/// finite; `normals`, `colors` and `uvs` are empty or as long as `positions`; `triangle_polygon` is
/// as long as `triangles`.
struct Mesh {
    std::string name;
    std::vector<glm::vec4> positions; ///< object space; w = 1 unless the scene says otherwise
    std::vector<glm::vec3> normals;   ///< unit length; never empty after `finish_mesh`
    std::vector<glm::vec4> colors;    ///< RGBA, linear; empty: white
    std::vector<glm::vec2>
        uvs; ///< origin at the image's top-left texel corner, v down; empty: none
    std::vector<std::uint32_t> polygon_start;        ///< polygons + 1 offsets into polygon_vertices
    std::vector<std::uint32_t> polygon_vertices;     ///< corners of all polygons
    std::vector<TriangleIndices> triangles;          ///< in polygon order
    std::vector<std::uint32_t> triangle_polygon;     ///< the polygon a triangle was made from
    std::vector<std::array<std::uint32_t, 2>> lines; ///< from the first vertex to the second
    std::vector<std::uint32_t> points;
    /// Where corners of one file vertex carry different texture coordinates or normals the vertex
    /// is split; this maps each vertex back to the file's. Empty: the identity.
    std::vector<std::uint32_t> file_vertex;

    [[nodiscard]] std::size_t polygon_count() const {
        return polygon_start.empty() ? 0 : polygon_start.size() - 1;
    }
    /// All that is drawn, numbered through: triangles, then lines, then points.
    [[nodiscard]] std::size_t primitive_count() const {
        return triangles.size() + lines.size() + points.size();
    }
    /// Precondition: index below primitive_count().
    [[nodiscard]] Primitive primitive(std::uint32_t index) const {
        if (index < triangles.size()) {
            return {PrimitiveKind::triangle, index, triangles[index]};
        }
        const std::uint32_t after = index - static_cast<std::uint32_t>(triangles.size());
        if (after < lines.size()) {
            const auto& [from, to] = lines[after];
            return {PrimitiveKind::line, after, {from, to, to}};
        }
        const std::uint32_t number = after - static_cast<std::uint32_t>(lines.size());
        const std::uint32_t at = points[number];
        return {PrimitiveKind::point, number, {at, at, at}};
    }
};

} // namespace hs::scene

namespace hs {
template <>
std::span<const Named<scene::PrimitiveKind>> names<scene::PrimitiveKind>();
} // namespace hs
