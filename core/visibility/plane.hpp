// The plane of a polygon, and on which side of it another polygon lies.
//
// Newell's sum, in Sutherland, Sproull and Schumacker, A Characterization of Ten Hidden-Surface
// Algorithms, 1974: right for polygons that are not quite plane, and at reflex corners.
#pragma once

#include "core/visibility/polygon.hpp"
#include "core/visibility/side.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <optional>
#include <span>

namespace hs::visibility {

/// A point this near to a plane counts as on it, relative to the coordinates of the scene. They
/// arrive in float, each off by up to 2⁻²⁴ of the largest; the point and the three corners that
/// made the plane add up to four of these. Less would cut neighbors in one face apart along slivers
/// that rounding made, more would take real steps between surfaces for one plane.
inline constexpr double relative_tolerance = 0x1p-22;

/// normal · p + offset = 0; the front half-space is where it is positive. Not normalized.
template <typename Space>
struct Plane {
    glm::dvec3 normal{0.0};
    double offset = 0.0;
    double tolerance = 0.0; ///< in the same multiples of a distance as `signed_distance`
};

using WindowPlane = Plane<WindowSpace>;
using WorldPlane = Plane<math::WorldSpace>;

/// Twice the area, along the normal: the side from which corners run counter-clockwise where axes
/// are right-handed.
template <typename Space>
[[nodiscard]] glm::dvec3 newell_sum(const Polygon<Space>& polygon) {
    glm::dvec3 sum{0.0};
    const glm::dvec3 origin = polygon.corners.front().position; // keeps the products small
    for (std::size_t i = 1; i + 1 < polygon.corners.size(); ++i) {
        sum += glm::cross(
            polygon.corners[i].position - origin, polygon.corners[i + 1].position - origin
        );
    }
    return sum;
}

template <typename Space>
[[nodiscard]] double area(const Polygon<Space>& polygon) {
    return 0.5 * glm::length(newell_sum(polygon));
}

template <typename Space>
[[nodiscard]] glm::dvec3 center(const Polygon<Space>& polygon) {
    glm::dvec3 sum{0.0};
    for (const Corner<Space>& corner : polygon.corners) {
        sum += corner.position;
    }
    return sum / static_cast<double>(polygon.corners.size());
}

/// Per axis the largest absolute coordinate: what tolerances are relative to. Per axis, because
/// window coordinates measure x and y in pixels but depth from 0 to 1.
template <typename Space>
[[nodiscard]] glm::dvec3 reach(std::span<const Polygon<Space>> polygons) {
    glm::dvec3 largest{0.0};
    for (const Polygon<Space>& polygon : polygons) {
        for (const Corner<Space>& corner : polygon.corners) {
            largest = glm::max(largest, glm::abs(corner.position));
        }
    }
    return largest;
}

/// A polygon without area gets the plane 0 = 0, on which everything lies.
template <typename Space>
[[nodiscard]] Plane<Space> plane_of(const Polygon<Space>& polygon, const glm::dvec3& reach) {
    Plane<Space> plane;
    plane.normal = newell_sum(polygon);
    plane.offset = -glm::dot(plane.normal, center(polygon));
    plane.tolerance = relative_tolerance * glm::dot(glm::abs(plane.normal), reach);
    return plane;
}

/// The same plane with the other side in front.
template <typename Space>
[[nodiscard]] Plane<Space> turned(const Plane<Space>& plane) {
    return {-plane.normal, -plane.offset, plane.tolerance};
}

template <typename Space>
[[nodiscard]] bool has_area(const Plane<Space>& plane) {
    return plane.normal != glm::dvec3{0.0};
}

template <typename Space>
[[nodiscard]] double signed_distance(const Plane<Space>& plane, const glm::dvec3& p) {
    return glm::dot(plane.normal, p) + plane.offset;
}

/// Of a homogeneous point; w = 0: a direction toward infinity.
template <typename Space>
[[nodiscard]] double signed_distance(const Plane<Space>& plane, const glm::dvec4& p) {
    return glm::dot(plane.normal, glm::dvec3{p}) + plane.offset * p.w;
}

/// Corners within the tolerance take no side.
template <typename Space>
[[nodiscard]] Side classify(const Plane<Space>& plane, const Polygon<Space>& polygon) {
    bool front = false;
    bool back = false;
    for (const Corner<Space>& corner : polygon.corners) {
        const double distance = signed_distance(plane, corner.position);
        front = front || distance > plane.tolerance;
        back = back || distance < -plane.tolerance;
    }
    return front && back ? Side::spanning : front ? Side::front : back ? Side::back : Side::on;
}

/// The plane's depth above a window position; nothing where it is seen edge-on.
[[nodiscard]] inline std::optional<double> depth_at(const WindowPlane& plane, double x, double y) {
    if (plane.normal.z == 0.0) {
        return std::nullopt;
    }
    return -(plane.normal.x * x + plane.normal.y * y + plane.offset) / plane.normal.z;
}

/// The plane with the eye, at negative depth, in front. Edge-on planes stay as they are.
[[nodiscard]] inline WindowPlane facing_the_eye(const WindowPlane& plane) {
    return plane.normal.z > 0.0 ? turned(plane) : plane;
}

} // namespace hs::visibility
