// The pyramid of view becoming the canonical view volume.
//
// Between eye space, clip space and NDC every map of the family is projective: straight lines stay
// straight and planes stay planes all the way, as they do under the projection itself. (Moving each
// point straight from its first to its last place would bend them.)
//
// Positions are drawn with x to the right, y up and z toward the viewer: what is farther from the
// eye lies at smaller z, in every space and for every convention.
#pragma once

#include "core/scene/settings.hpp"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <optional>

namespace hs::explain {

/// Which way depth runs in the spaces of a frame.
struct DepthDirections {
    float forward = -1.0F;               ///< the sign of eye-space z in front of the eye
    bool ndc_grows_with_distance = true; ///< false: reversed
};

/// A point on the way: 0 in eye space, 1 in clip space as (x, y, −w), 2 in NDC. `eye` has w = 1.
/// Exact at 0, 1 and 2. Empty where the point has no place: behind the eye after the divide.
std::optional<glm::vec3>
morphed(const glm::vec4& eye, const glm::vec4& clip, const DepthDirections& directions, float at);

} // namespace hs::explain
