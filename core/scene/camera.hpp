// Cameras: where the eye stands (view matrix) and how it sees (projection matrix).
//
// Sources: OpenGL 4.6 compatibility profile, section 12.1 (Frustum, Ortho); gluLookAt. Differs:
// depth conventions and the direction of view are settings, so that lectures of either tradition
// find theirs.
#pragma once

#include "core/base/named.hpp"
#include "core/math/space.hpp"
#include "core/scene/settings.hpp"

#include <glm/vec3.hpp>

#include <cstdint>

namespace hs::scene {

enum class ProjectionKind : std::uint8_t {
    perspective,
    orthographic,
    frustum,
    identity
};
enum class Forward : std::uint8_t {
    minus_z,
    plus_z
};

struct Projection {
    ProjectionKind kind = ProjectionKind::perspective;
    float fov_y = 45.0F; ///< perspective: full vertical angle in degrees, in (0, 180)
    float height = 2.0F; ///< orthographic: height of the view volume, > 0
    float left = -1.0F, right = 1.0F, bottom = -1.0F,
          top = 1.0F;  ///< frustum: limits on the near plane
    float near = 0.1F; ///< distance, > 0 for perspective and frustum
    float far = 10.0F; ///< distance, > near
    friend bool operator==(const Projection&, const Projection&) = default;
};

struct Camera {
    glm::vec3 eye{0.0F, 0.0F, 3.0F};
    glm::vec3 target{0.0F, 0.0F, 0.0F};
    glm::vec3 up{0.0F, 1.0F, 0.0F};
    Forward forward = Forward::minus_z;
    Projection projection;
    friend bool operator==(const Camera&, const Camera&) = default;
};

using ViewTransform = math::Transform<math::WorldSpace, math::EyeSpace>;
using ProjectionTransform = math::Transform<math::EyeSpace, math::ClipSpace>;

/// The basis of the look-at matrix, for stepping through its construction. All unit vectors in
/// world space.
struct LookAtBasis {
    glm::vec3 backward; ///< eye − target for forward = -z (target − eye for +z): the eye's z axis
    glm::vec3 right;
    glm::vec3 up;
};

/// Precondition (checked by scene loading): eye != target and up is not parallel to the line of
/// sight.
LookAtBasis look_at_basis(const Camera& camera);

/// The direction of sight in eye space, along z: −1 (OpenGL) or +1. An identity projection looks
/// along +z.
float forward_sign(const Camera& camera);

/// World to eye. The identity for an identity projection.
ViewTransform view_transform(const Camera& camera);

/// Eye to clip. `aspect` is width / height of the viewport.
ProjectionTransform
projection_transform(const Camera& camera, float aspect, DepthConvention convention);

} // namespace hs::scene

namespace hs {
template <>
std::span<const Named<scene::ProjectionKind>> names<scene::ProjectionKind>();
template <>
std::span<const Named<scene::Forward>> names<scene::Forward>();
} // namespace hs
