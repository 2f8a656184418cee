// A mesh as the pipeline sees it: vertices, polygons as they were given, and the triangles made
// from them.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

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
    std::vector<std::uint32_t> polygon_start;    ///< polygons + 1 offsets into polygon_vertices
    std::vector<std::uint32_t> polygon_vertices; ///< corners of all polygons
    std::vector<TriangleIndices> triangles;      ///< in polygon order
    std::vector<std::uint32_t> triangle_polygon; ///< the polygon a triangle was made from
    /// Where corners of one file vertex carry different texture coordinates or normals the vertex
    /// is split; this maps each vertex back to the file's. Empty: the identity.
    std::vector<std::uint32_t> file_vertex;

    [[nodiscard]] std::size_t polygon_count() const {
        return polygon_start.empty() ? 0 : polygon_start.size() - 1;
    }
};

} // namespace hs::scene
