// What the visible-surface algorithms order: convex polygons that remember their triangle.
//
// Coordinates are double here, unlike in the pipeline: deciding on which side of a plane a vertex
// lies is all these algorithms do, and the planes come from vertices in float.
#pragma once

#include "core/math/space.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace hs::visibility {

/// Window coordinates after the divide: x right and y down in pixels, z the depth, growing away
/// from the eye. The divide keeps planes plane and straight lines straight, and puts the eye
/// infinitely far away at negative depth.
struct WindowSpace {};

/// A corner of a polygon, in `Space`.
template <typename Space>
struct Corner {
    glm::dvec3 position{0.0};
    /// Of its triangle's three vertices in clip coordinates, scaled so that they are linear along
    /// edges: in the world they sum to one, in the window to one over the corner's clip w.
    glm::dvec3 weights{0.0};
    friend bool operator==(const Corner&, const Corner&) = default;
};

/// A convex polygon: a triangle, what clipping or splitting left of one, or a flat convex face of
/// several triangles. Such a face has no weights and is only for algorithms that never split
/// (painter's, front lists): it is drawn by drawing its triangles one after the other.
template <typename Space>
struct Polygon {
    std::uint32_t triangle = 0;       ///< over the whole frame, in file order; of a face the first
    std::uint32_t triangle_count = 1; ///< of a face: that many, numbered on from the first
    std::uint32_t part = 0; ///< parts of one triangle are numbered in the order they were cut off
    bool split = false;     ///< an algorithm cut it: draw these corners, not the whole triangle
    std::vector<Corner<Space>> corners; ///< three or more, in the triangle's winding
};

using WindowPolygon = Polygon<WindowSpace>;
using WorldPolygon = Polygon<math::WorldSpace>;

} // namespace hs::visibility
