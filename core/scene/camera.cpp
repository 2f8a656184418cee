#include "core/scene/camera.hpp"

#include "core/base/check.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace hs::scene {

namespace {

/// NDC z at the near and at the far plane.
struct DepthRange {
    float near = -1.0F;
    float far = 1.0F;
};

DepthRange depth_range(DepthConvention convention) {
    switch (convention) {
    case DepthConvention::opengl: return {-1.0F, 1.0F};
    case DepthConvention::direct3d: return {0.0F, 1.0F};
    case DepthConvention::reversed: return {1.0F, 0.0F};
    }
    HS_CHECK(false, "every depth convention is handled");
    return {};
}

/// The sign that turns an eye-space z into a distance in front of the eye.
float forward_sign(Forward forward) {
    return forward == Forward::minus_z ? -1.0F : 1.0F;
}

glm::mat4
perspective_matrix(const Projection& p, float aspect, float sign, const DepthRange& range) {
    const float half_angle = p.fov_y * (std::numbers::pi_v<float> / 360.0F);
    const float cotangent = 1.0F / std::tan(half_angle);
    glm::mat4 m{0.0F};
    m[0][0] = cotangent / aspect;
    m[1][1] = cotangent;
    // With d = sign·z: z_clip = A·d + B and w = d, where A + B/near and A + B/far are the range's
    // ends.
    m[2][2] = sign * ((range.far * p.far - range.near * p.near) / (p.far - p.near));
    m[3][2] = (range.near - range.far) * p.far * p.near / (p.far - p.near);
    m[2][3] = sign;
    return m;
}

/// Off-axis: the line of sight need not meet the middle of the image.
glm::mat4 frustum_matrix(const Projection& p, float sign, const DepthRange& range) {
    glm::mat4 m{0.0F};
    m[0][0] = 2.0F * p.near / (p.right - p.left);
    m[1][1] = 2.0F * p.near / (p.top - p.bottom);
    m[2][0] = -sign * ((p.right + p.left) / (p.right - p.left));
    m[2][1] = -sign * ((p.top + p.bottom) / (p.top - p.bottom));
    m[2][2] = sign * ((range.far * p.far - range.near * p.near) / (p.far - p.near));
    m[3][2] = (range.near - range.far) * p.far * p.near / (p.far - p.near);
    m[2][3] = sign;
    return m;
}

glm::mat4
orthographic_matrix(const Projection& p, float aspect, float sign, const DepthRange& range) {
    glm::mat4 m{1.0F};
    m[0][0] = 2.0F / (p.height * aspect);
    m[1][1] = 2.0F / p.height;
    // z_clip = A·d + B, linear in the distance d = sign·z; w stays 1.
    m[2][2] = sign * ((range.far - range.near) / (p.far - p.near));
    m[3][2] = (range.near * p.far - range.far * p.near) / (p.far - p.near);
    return m;
}

} // namespace

float forward_sign(const Camera& camera) {
    return camera.projection.kind == ProjectionKind::identity ? 1.0F : forward_sign(camera.forward);
}

LookAtBasis look_at_basis(const Camera& camera) {
    const glm::vec3 sight = glm::normalize(camera.target - camera.eye);
    // Right is right on screen for both directions of view, so +z makes the eye's basis
    // left-handed.
    const glm::vec3 right = glm::normalize(glm::cross(sight, camera.up));
    return {
        .backward = sight * forward_sign(camera.forward),
        .right = right,
        .up = glm::cross(right, sight),
    };
}

ViewTransform view_transform(const Camera& camera) {
    if (camera.projection.kind == ProjectionKind::identity) {
        return {};
    }
    const LookAtBasis basis = look_at_basis(camera);
    glm::mat4 m{1.0F};
    // The rows are the eye's axes; the last column moves the eye to the origin.
    const glm::vec3 axes[] = {basis.right, basis.up, basis.backward};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            m[column][row] = axes[row][column];
        }
        m[3][row] = -glm::dot(axes[row], camera.eye);
    }
    return {m};
}

ProjectionTransform
projection_transform(const Camera& camera, float aspect, DepthConvention convention) {
    const Projection& projection = camera.projection;
    const float sign = forward_sign(camera.forward);
    const DepthRange range = depth_range(convention);
    switch (projection.kind) {
    case ProjectionKind::perspective: return {perspective_matrix(projection, aspect, sign, range)};
    case ProjectionKind::orthographic:
        return {orthographic_matrix(projection, aspect, sign, range)};
    case ProjectionKind::frustum: return {frustum_matrix(projection, sign, range)};
    case ProjectionKind::identity: return {};
    }
    HS_CHECK(false, "every projection kind is handled");
    return {};
}

} // namespace hs::scene

namespace hs {

namespace {

constexpr Named<scene::ProjectionKind> projection_names[] = {
    {scene::ProjectionKind::perspective,
     "perspective",
     "a symmetric pyramid of view given by its vertical angle: what is far looks small"},
    {scene::ProjectionKind::orthographic,
     "orthographic",
     "parallel lines of sight: size does not depend on distance"},
    {scene::ProjectionKind::frustum,
     "frustum",
     "a pyramid of view given by left, right, bottom and top on the near plane, not always "
     "symmetric"},
    {scene::ProjectionKind::identity,
     "identity",
     "no camera at all: object coordinates after the object's transform are clip coordinates"},
};

constexpr Named<scene::Forward> forward_names[] = {
    {scene::Forward::minus_z, "-z", "the eye looks along its negative z axis, as OpenGL does"},
    {scene::Forward::plus_z,
     "+z",
     "the eye looks along its positive z axis, so depth grows with z"},
};

} // namespace

template <>
std::span<const Named<scene::ProjectionKind>> names<scene::ProjectionKind>() {
    return projection_names;
}
template <>
std::span<const Named<scene::Forward>> names<scene::Forward>() {
    return forward_names;
}

} // namespace hs
