// The planes of homogeneous rasterization where they stand in space: each holds the eye and an edge
// of the triangle, and a pixel is covered if the ray through it runs on the inner side of all
// three.
//
// Olano and Greer, Triangle Scan Conversion Using 2D Homogeneous Coordinates, 1997.
#pragma once

#include "core/trace/detail.hpp"
#include "core/trace/step.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <optional>

namespace hs::explain {

/// In eye space; the eye is the origin.
struct PlaneThroughEye {
    std::array<glm::vec3, 2> edge{}; ///< its ends, as they stand: one may lie behind the eye
    glm::vec3 normal{0.0F};          ///< of length 1, toward the vertex opposite
};

struct PlanesThroughEye {
    std::array<PlaneThroughEye, 3> planes{}; ///< of E01, E12, E20
    std::optional<glm::vec3> ray; ///< of length 1 through the step's pixel, if it has one
};

/// Empty unless the step comes after the setup of a triangle's planes, the camera has an eye, and
/// the triangle is not seen edge-on.
[[nodiscard]] std::optional<PlanesThroughEye> planes_through_eye(
    const trace::Recording& recording, const trace::StepDetail& detail, const trace::Step& step
);

} // namespace hs::explain
