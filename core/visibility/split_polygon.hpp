// A convex polygon cut in two by a plane.
//
// Sutherland and Hodgman, Reentrant Polygon Clipping, 1974, keeping both sides. A new corner is
// always computed from the front end of its edge toward the back end, once for both halves: the
// halves share it to the bit, and so does a neighbor that is cut along the same edge.
#pragma once

#include "core/visibility/plane.hpp"

namespace hs::visibility {

template <typename Space>
struct Halves {
    Polygon<Space> front;
    Polygon<Space> back;
};

/// Where the edge from `front` (distance d_front > 0) to `back` (d_back < 0) meets the plane.
template <typename Space>
[[nodiscard]] Corner<Space>
cut_edge(const Corner<Space>& front, double d_front, const Corner<Space>& back, double d_back) {
    const double t = d_front / (d_front - d_back);
    const auto between = [t](const glm::dvec3& a, const glm::dvec3& b) { return a + t * (b - a); };
    return {
        between(front.position, back.position),
        between(front.weights, back.weights),
    };
}

/// Precondition: the polygon spans the plane. Both halves keep its winding; corners on the plane
/// belong to both.
template <typename Space>
[[nodiscard]] Halves<Space>
split_polygon(const Polygon<Space>& polygon, const Plane<Space>& plane) {
    Halves<Space> halves{polygon, polygon};
    halves.front.corners.clear();
    halves.back.corners.clear();
    halves.front.split = halves.back.split = true;
    const std::size_t count = polygon.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Corner<Space>& current = polygon.corners[i];
        const Corner<Space>& next = polygon.corners[(i + 1) % count];
        const double d_current = signed_distance(plane, current.position);
        const double d_next = signed_distance(plane, next.position);

        // Keep the corner on its side, or on both
        if (d_current >= -plane.tolerance) {
            halves.front.corners.push_back(current);
        }
        if (d_current <= plane.tolerance) {
            halves.back.corners.push_back(current);
        }

        // An edge that changes sides has a new corner in both halves
        if (d_current > plane.tolerance && d_next < -plane.tolerance) {
            const Corner<Space> corner = cut_edge(current, d_current, next, d_next);
            halves.front.corners.push_back(corner);
            halves.back.corners.push_back(corner);
        } else if (d_current < -plane.tolerance && d_next > plane.tolerance) {
            const Corner<Space> corner = cut_edge(next, d_next, current, d_current);
            halves.front.corners.push_back(corner);
            halves.back.corners.push_back(corner);
        }
    }
    return halves;
}

} // namespace hs::visibility
