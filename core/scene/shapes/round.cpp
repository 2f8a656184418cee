// Sphere, torus and torus knot: closed surfaces with seams in their texture coordinates only.
#include "core/scene/shapes/families.hpp"
#include "core/scene/shapes/grid.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hs::scene::shapes {

namespace {

/// Divides so that the wanted number is met as nearly as one factor allows.
int nearest_quotient(int triangles, int per_column, int lowest) {
    const double quotient = static_cast<double>(triangles) / per_column;
    return std::max(lowest, static_cast<int>(std::lround(quotient)));
}

/// A closed tube has 2 triangles per quad; `ratio` is how many columns it has per row.
GridSize tube_size(int triangles, double ratio, int fewest_columns) {
    const double rows = std::sqrt(static_cast<double>(triangles) / (2.0 * ratio));
    const int around = std::max(3, static_cast<int>(std::lround(rows)));
    return {nearest_quotient(triangles, 2 * around, fewest_columns), around};
}

/// A point of a closed curve and the plane across it, in which the tube's circle is drawn.
struct CurveFrame {
    glm::dvec3 center;
    glm::dvec3 normal;
    glm::dvec3 binormal; ///< normal × tangent
};

/// The trefoil: twice around the axis while three times around the tube of the torus that carries
/// it.
CurveFrame trefoil(int step, int steps) {
    constexpr int windings = 2;
    constexpr int turns = 3;
    constexpr double ring = 0.55;
    constexpr double offset = 0.25;
    const Turn a = turn(step * windings % steps, steps);
    const Turn b = turn(step * turns % steps, steps);
    const glm::dvec3 outward{a.cosine, a.sine, 0.0};
    const glm::dvec3 along{-a.sine, a.cosine, 0.0};
    const glm::dvec3 axis{0.0, 0.0, 1.0};
    const auto cosine = static_cast<double>(b.cosine);
    const auto sine = static_cast<double>(b.sine);
    const double distance = ring + offset * cosine;
    const glm::dvec3 tangent = glm::normalize(
        windings * distance * along + turns * offset * (cosine * axis - sine * outward)
    );
    // The normal of the carrying torus stays across the curve and closes after one period.
    const glm::dvec3 normal = cosine * outward + sine * axis;
    return {distance * outward + offset * sine * axis, normal, glm::cross(normal, tangent)};
}

} // namespace

Mesh sphere(int triangles) {
    // Twice as many slices as stacks; the two polar stacks have one triangle per slice instead of
    // two.
    const double half = static_cast<double>(triangles) / 4.0;
    const int stacks = std::max(2, static_cast<int>(std::lround(0.5 + std::sqrt(0.25 + half))));
    const int slices = nearest_quotient(triangles, 2 * (stacks - 1), 3);
    Mesh mesh;
    add_sheet(mesh, {slices, stacks}, false, [=](int column, int row) {
        const bool pole = row == 0 || row == stacks;
        const Turn longitude = turn(column, slices);
        const Turn from_south = turn(row, 2 * stacks);
        const float radius = pole ? 0.0F : from_south.sine;
        const float height = pole ? (row == 0 ? -1.0F : 1.0F) : -from_south.cosine;
        const glm::vec3 p{radius * longitude.sine, height, radius * longitude.cosine};
        return SurfacePoint{p, p};
    });
    return mesh;
}

Mesh torus(int triangles) {
    constexpr float ring = 0.7F;
    constexpr float tube = 0.3F;
    const GridSize size = tube_size(triangles, 2.0, 3);
    Mesh mesh;
    add_sheet(mesh, size, false, [=](int column, int row) {
        const Turn a = turn(column, size.columns);
        const Turn b = turn(row, size.rows);
        const glm::vec3 outward{a.cosine, a.sine, 0.0F};
        const glm::vec3 normal = b.cosine * outward + glm::vec3{0.0F, 0.0F, b.sine};
        return SurfacePoint{ring * outward + tube * normal, normal};
    });
    return mesh;
}

Mesh torus_knot(int triangles) {
    constexpr double tube = 0.15;
    const GridSize size = tube_size(triangles, 8.0, 12);
    Mesh mesh;
    add_sheet(mesh, size, false, [=](int column, int row) {
        const CurveFrame frame = trefoil(column % size.columns, size.columns);
        const Turn b = turn(row, size.rows);
        const glm::dvec3 normal = static_cast<double>(b.cosine) * frame.normal +
                                  static_cast<double>(b.sine) * frame.binormal;
        return SurfacePoint{glm::vec3{frame.center + tube * normal}, glm::vec3{normal}};
    });
    return mesh;
}

} // namespace hs::scene::shapes
