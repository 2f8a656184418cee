// Facing as lectures teach it: in eye space, from the polygon's normal and the line of sight.
//
// Normal by Newell's sum (Sutherland, Sproull and Schumacker, A Characterization of Ten
// Hidden-Surface Algorithms, 1974, appendix): a cross product at one corner points backwards where
// that corner is reflex. The pipeline itself decides by the sign of the snapped window area
// (facing.hpp); the two differ only where that area is within one snap of zero.
#pragma once

#include "core/math/space.hpp"
#include "core/scene/settings.hpp"

#include <glm/vec3.hpp>

#include <span>

namespace hs::geometry {

struct EyeFacing {
    glm::vec3 normal{
        0.0F}; ///< twice the area long; to the side that sees the polygon counterclockwise
    glm::vec3 center{0.0F}; ///< mean of the vertices
    glm::vec3 view{0.0F};   ///< from the eye to the center; (0, 0, −1) for orthographic cameras
    float dot = 0.0F;       ///< view · normal: < 0 front, > 0 back, 0 edge-on
};

/// `polygon` has at least three vertices with w = 1. `forward` is the direction of sight in eye
/// space along z: −1 (OpenGL) or +1. With front_face = cw the normal is turned around.
EyeFacing eye_facing(
    std::span<const math::EyePosition> polygon,
    scene::Winding front_face,
    bool orthographic,
    float forward
);

} // namespace hs::geometry
