// Flat faces, each an n x n grid of quads.
#include "core/scene/shapes/families.hpp"
#include "core/scene/shapes/grid.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hs::scene::shapes {

namespace {

/// n such that `faces` n x n grids have nearly the wanted number of triangles.
int divisions(int triangles, int faces) {
    const double squares = static_cast<double>(triangles) / (2.0 * faces);
    return std::max(1, static_cast<int>(std::lround(std::sqrt(squares))));
}

/// The square with the given center, spanned by the unit vectors right and up; the normal is right
/// × up.
void add_face(Mesh& mesh, int n, glm::vec3 center, glm::vec3 right, glm::vec3 up) {
    const auto coordinate = [n](int i) {
        // The numerator is exact, so i and n − i give exactly opposite numbers and the cube's edges
        // meet.
        return static_cast<float>(2 * i - n) / static_cast<float>(n);
    };
    add_sheet(mesh, {n, n}, true, [&](int column, int row) {
        return SurfacePoint{
            center + coordinate(column) * right + coordinate(row) * up, glm::cross(right, up)};
    });
}

} // namespace

Mesh plane(int triangles) {
    Mesh mesh;
    add_face(mesh, divisions(triangles, 1), {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    return mesh;
}

Mesh cube(int triangles) {
    Mesh mesh;
    const int n = divisions(triangles, 6);
    add_face(mesh, n, {0, 0, 1}, {1, 0, 0}, {0, 1, 0});
    add_face(mesh, n, {1, 0, 0}, {0, 0, -1}, {0, 1, 0});
    add_face(mesh, n, {0, 0, -1}, {-1, 0, 0}, {0, 1, 0});
    add_face(mesh, n, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0});
    add_face(mesh, n, {0, 1, 0}, {1, 0, 0}, {0, 0, -1});
    add_face(mesh, n, {0, -1, 0}, {1, 0, 0}, {0, 0, 1});
    return mesh;
}

} // namespace hs::scene::shapes
