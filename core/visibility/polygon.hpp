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
    glm::dvec3 weights{
        0.0}; ///< of its triangle's three vertices in clip coordinates; they sum to one
};

/// A convex polygon: a triangle, or what clipping or splitting left of one.
template <typename Space>
struct Polygon {
    std::uint32_t triangle = 0; ///< over the whole frame, in file order
    std::uint16_t part = 0;     ///< 0 for a whole triangle; splitting numbers the parts from there
    std::vector<Corner<Space>> corners; ///< three or more, in the triangle's winding
};

using WindowPolygon = Polygon<WindowSpace>;
using WorldPolygon = Polygon<math::WorldSpace>;

} // namespace hs::visibility
