// Do two convex polygons overlap as the eye sees them, and where?
//
// The separating-axis test for convex polygons (Gottschalk, Lin and Manocha, OBBTree, 1996): two
// convex polygons do not overlap iff an edge of one has all of the other outside. Polygons that
// only touch do not overlap, and one without area overlaps nothing. Touching is generous by the
// tolerance of a plane: corners that splitting put on a neighbor's edge lie there only to rounding.
#pragma once

#include "core/visibility/plane.hpp"

#include <glm/vec2.hpp>

#include <vector>

namespace hs::visibility {

/// The box around a polygon.
struct Extents {
    glm::dvec3 low{0.0};
    glm::dvec3 high{0.0};
};

template <typename Space>
[[nodiscard]] Extents extents_of(const Polygon<Space>& polygon) {
    Extents extents{polygon.corners.front().position, polygon.corners.front().position};
    for (const Corner<Space>& corner : polygon.corners) {
        extents.low = glm::min(extents.low, corner.position);
        extents.high = glm::max(extents.high, corner.position);
    }
    return extents;
}

/// From the end of one interval to the beginning of the other along an axis: >= 0 when they do not
/// overlap, and at most touch.
[[nodiscard]] inline double gap(const Extents& a, const Extents& b, int axis) {
    return glm::max(a.low[axis] - b.high[axis], b.low[axis] - a.high[axis]);
}

/// Do the projections overlap? `reach` is that of the scene.
[[nodiscard]] bool
projections_overlap(const WindowPolygon& a, const WindowPolygon& b, const glm::dvec3& reach);

/// Corners of the common part of two projections, in no particular winding; none if they do not
/// overlap.
[[nodiscard]] std::vector<glm::dvec2>
common_region(const WindowPolygon& a, const WindowPolygon& b, const glm::dvec3& reach);

} // namespace hs::visibility
