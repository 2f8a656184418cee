// Why normals travel by the inverse transpose: a tangent moved by the matrix stays on the surface,
// a normal moved by the same matrix does not stay perpendicular to it.
//
// Turkowski, Properties of Surface-Normal Transformations, Graphics Gems, 1990:
// (M·t)·(M⁻ᵀ·n) = tᵀ·Mᵀ·M⁻ᵀ·n = t·n.
#pragma once

#include "core/trace/recording.hpp"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>

namespace hs::explain {

/// All vectors have unit length, so that products are cosines.
struct NormalStory {
    std::uint32_t edge_end = 0; ///< the vertex at the other end of the edge the tangent is made of
    glm::mat3 matrix{1.0F};     ///< object to eye, for directions
    glm::mat3 inverse_transpose{1.0F};
    glm::vec3 normal{0.0F};  ///< object space
    glm::vec3 tangent{0.0F}; ///< object space: the edge without its part along the normal
    glm::vec3 moved_tangent{0.0F};
    glm::vec3 by_matrix{0.0F}; ///< the wrong normal
    glm::vec3 by_inverse_transpose{0.0F};
    float dot_before = 0.0F;    ///< normal · tangent
    float dot_by_matrix = 0.0F; ///< by_matrix · moved_tangent
    float dot_by_inverse_transpose = 0.0F;
    bool executed = true; ///< the frame multiplies normals by the inverse transpose
};

/// For the edge at the vertex that shows the difference best. Empty: the vertex has no normal or no
/// edge beside it, or the matrix squashes the object flat and has no inverse.
std::optional<NormalStory>
normal_story(const trace::Recording& recording, std::uint32_t object, std::uint32_t vertex);

} // namespace hs::explain
