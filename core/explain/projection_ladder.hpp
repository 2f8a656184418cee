// From "drop z" to the projection matrix that is executed, rung by rung, with what each rung leaves
// of depth; and the same projection by hand, over the image plane.
//
// OpenGL 4.6 compatibility profile, section 12.1 (Frustum, Ortho). The distance d of a point is
// measured along the line of sight: d = −z where the eye looks along −z.
#pragma once

#include "core/scene/camera.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hs::explain {

/// A matrix on the way, applied to one point.
struct ProjectionRung {
    std::string_view title;
    std::string_view idea;     ///< what it does, in a sentence
    std::string_view survives; ///< what is left of depth, in a sentence
    glm::mat4 matrix{1.0F};
    glm::vec4 clip{0.0F};
    std::optional<glm::vec3> divided{}; ///< empty where w = 0
};

/// Perspective: drop to the plane at distance 1, keep 1/d, map near and far. Parallel projections:
/// drop z, map near and far. The last rung is the matrix the frame runs. No camera: that alone.
std::vector<ProjectionRung> projection_ladder(
    const scene::Camera& camera,
    float aspect,
    scene::DepthConvention convention,
    const glm::vec3& eye_point
);

/// The view volume on the near plane, whichever way the camera is written.
struct FrustumLimits {
    float left = -1.0F, right = 1.0F, bottom = -1.0F, top = 1.0F;
    float near = 0.1F, far = 10.0F;
};
FrustumLimits frustum_limits(const scene::Projection& projection, float aspect);

/// One entry of the projection matrix that is not 0: where, what it is made of, what it does.
struct MatrixEntry {
    int row = 0;
    int column = 0;
    std::string symbolic;
    std::string with_numbers;
    float value = 0.0F;
    std::string meaning;
};
/// Row by row. Empty for an identity projection.
std::vector<MatrixEntry>
matrix_entries(const scene::Camera& camera, float aspect, scene::DepthConvention convention);

/// What one convention makes of a point's depth.
struct ConventionDepth {
    scene::DepthConvention convention = scene::DepthConvention::opengl;
    float a = 0.0F; ///< z_clip = a·z + b
    float b = 0.0F;
    float z_clip = 0.0F;
    float z_ndc = 0.0F;
    float depth = 0.0F; ///< before it is rounded to the buffer's format
};
/// OpenGL, Direct3D, reversed. Empty where w = 0.
std::optional<std::array<ConventionDepth, 3>>
depth_in_conventions(const scene::Camera& camera, float aspect, const glm::vec3& eye_point);

/// The long way: similar triangles to the image plane, l r b t to NDC, NDC to pixels. z is kept
/// aside.
struct ByHand {
    float distance = 0.0F;
    glm::vec2 on_plane{0.0F};
    glm::vec2 ndc{0.0F};
    glm::vec2 raster{0.0F}; ///< y down
};
/// Empty at and behind the eye.
std::optional<ByHand>
project_by_hand(const scene::Camera& camera, int width, int height, const glm::vec3& eye_point);

} // namespace hs::explain
