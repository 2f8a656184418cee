// Polygons for the visible-surface algorithms, and what is seen of them at a point, found without
// those algorithms.
#pragma once

#include "core/visibility/polygon.hpp"
#include "tests/support/random_scene.hpp"

#include <glm/vec2.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hs::tests {

/// Triangle number `triangle`, with the weights of its own vertices.
visibility::WindowPolygon window_triangle(
    std::uint32_t triangle, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c
);
visibility::WorldPolygon world_triangle(
    std::uint32_t triangle, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c
);

/// A face of two triangles, parallel to the window, from one corner to the opposite one.
visibility::WindowPolygon
window_rectangle(std::uint32_t number, const glm::dvec2& low, const glm::dvec2& high, double depth);

inline constexpr double window_size = 100.0;

/// Triangles of about `size` pixels anywhere in a window of 100 × 100 pixels, which penetrate each
/// other freely. Coordinates are floats.
std::vector<visibility::WindowPolygon>
random_window_triangles(std::uint32_t count, float size, Random& random);

/// The lecture's six polygons, numbers 1 to 6 at indices 0 to 5.
std::vector<visibility::WindowPolygon> six_polygons();

/// `count` bars around the middle of the window, each in front of the next: a cycle.
std::vector<visibility::WindowPolygon> ring_of_bars(std::uint32_t count);

/// The triangle that the last polygon of `order` over a point belongs to; −1: none. Nothing where
/// the point is within `margin` pixels of any edge.
std::optional<int> painted_at(
    std::span<const visibility::WindowPolygon> polygons,
    std::span<const std::int32_t> order,
    const glm::dvec2& point,
    double margin
);

/// The triangle nearest to the eye at a point, by its barycentric depth; −1: none. Nothing where
/// the point is within `margin` pixels of any edge, or the two nearest differ in depth by less than
/// `depth_margin`.
std::optional<int> nearest_at(
    std::span<const visibility::WindowPolygon> triangles,
    const glm::dvec2& point,
    double margin,
    double depth_margin
);

/// Does every polygon of `order` over a point come after those that are farther there? Depths are
/// those of the triangles given; nothing where the point is within `margin` pixels of an edge or
/// two of them differ by less than `depth_margin`.
std::optional<bool> back_to_front_at(
    std::span<const visibility::WindowPolygon> given,
    std::span<const visibility::WindowPolygon> polygons,
    std::span<const std::int32_t> order,
    const glm::dvec2& point,
    double margin,
    double depth_margin
);

/// Triangles of about `size` anywhere in the cube from −1 to 1, which penetrate each other freely.
/// Coordinates are floats.
std::vector<visibility::WorldPolygon>
random_world_triangles(std::uint32_t count, float size, Random& random);

struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0};
};

/// From an eye (w = 0: a direction toward it) to a random point of the cube.
Ray random_ray(const glm::dvec4& eye, Random& random);

/// The triangle of the first polygon in `order`, front to back, that a ray meets; −1: none. Nothing
/// where the ray passes within `margin` of an edge, or along a plane.
std::optional<int> first_met(
    std::span<const visibility::WorldPolygon> polygons,
    std::span<const std::int32_t> order,
    const Ray& ray,
    double margin
);

/// The triangle that a ray meets nearest to its origin; −1: none. Nothing where the ray passes
/// within `margin` of an edge, along a plane, or meets two triangles as near to each other.
std::optional<int>
nearest_met(std::span<const visibility::WorldPolygon> triangles, const Ray& ray, double margin);

/// Does a ray meet the polygons of `order` one farther than the other? Nothing where it passes
/// within `margin` of an edge or of the eye, along a plane, or meets two as near to each other.
std::optional<bool> front_to_back_along(
    std::span<const visibility::WorldPolygon> polygons,
    std::span<const std::int32_t> order,
    const Ray& ray,
    double margin
);

} // namespace hs::tests
