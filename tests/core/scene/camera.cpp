#include "core/scene/camera.hpp"

#include "tests/support/catch.hpp"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <random>

using namespace hs;
using namespace hs::scene;

namespace {

void check_near(const glm::mat4& a, const glm::mat4& b) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            INFO("row " << row << ", column " << column);
            CHECK(a[column][row] == Approx(b[column][row]).margin(1e-5));
        }
    }
}

Camera camera_of(const Projection& projection, Forward forward = Forward::minus_z) {
    Camera camera;
    camera.forward = forward;
    camera.projection = projection;
    return camera;
}

const Projection perspective{
    .kind = ProjectionKind::perspective, .fov_y = 50.0F, .near = 0.5F, .far = 8.0F};
const Projection orthographic{
    .kind = ProjectionKind::orthographic, .height = 3.0F, .near = 0.5F, .far = 8.0F};
const Projection frustum{
    .kind = ProjectionKind::frustum,
    .left = -0.3F,
    .right = 0.5F,
    .bottom = -0.2F,
    .top = 0.6F,
    .near = 0.5F,
    .far = 8.0F};

/// NDC z of the point at a distance in front of the eye.
float ndc_z(const Camera& camera, float distance, DepthConvention convention) {
    const float z = camera.forward == Forward::minus_z ? -distance : distance;
    const auto clip =
        projection_transform(camera, 1.5F, convention)(math::EyePosition{0.1F, 0.2F, z, 1.0F});
    return clip.z / clip.w;
}

} // namespace

TEST_CASE("the view matrix is that of glm::lookAt", "[unit][scene]") {
    std::mt19937 random{7};
    const auto coordinate = [&] { return static_cast<float>(random() % 2000) / 100.0F - 10.0F; };
    for (int i = 0; i < 200; ++i) {
        Camera camera;
        camera.eye = {coordinate(), coordinate(), coordinate()};
        camera.target = camera.eye + glm::vec3{coordinate(), coordinate(), coordinate() + 20.0F};
        camera.up = {0.3F, 1.0F, -0.2F};
        check_near(
            view_transform(camera).matrix, glm::lookAt(camera.eye, camera.target, camera.up)
        );
    }
}

TEST_CASE("looking along +z mirrors only the eye's z", "[unit][scene]") {
    Camera camera;
    camera.eye = {1.0F, 2.0F, 3.0F};
    const glm::mat4 minus = view_transform(camera).matrix;
    camera.forward = Forward::plus_z;
    const glm::mat4 plus = view_transform(camera).matrix;
    const glm::mat4 mirror = glm::scale(glm::mat4{1.0F}, glm::vec3{1.0F, 1.0F, -1.0F});
    check_near(plus, mirror * minus);
}

TEST_CASE("the look-at basis is orthonormal and right stays right on screen", "[unit][scene]") {
    for (const Forward forward : {Forward::minus_z, Forward::plus_z}) {
        Camera camera;
        camera.eye = {4.0F, 3.0F, 2.0F};
        camera.forward = forward;
        const LookAtBasis basis = look_at_basis(camera);
        CHECK(glm::length(basis.right) == Approx(1.0F));
        CHECK(glm::length(basis.up) == Approx(1.0F));
        CHECK(glm::length(basis.backward) == Approx(1.0F));
        CHECK(glm::dot(basis.right, basis.up) == Approx(0.0F).margin(1e-6));
        CHECK(glm::dot(basis.right, basis.backward) == Approx(0.0F).margin(1e-6));
        const float handedness = glm::dot(glm::cross(basis.right, basis.up), basis.backward);
        CHECK(handedness == Approx(forward == Forward::minus_z ? 1.0F : -1.0F));
    }
}

TEST_CASE("projections are those of GLM in both handednesses and depth ranges", "[unit][scene]") {
    using enum DepthConvention;
    const float fov = glm::radians(50.0F);
    const float half_width = 1.5F * 1.5F;
    const auto matrix = [](const Projection& p, Forward f, DepthConvention c) {
        return projection_transform(camera_of(p, f), 1.5F, c).matrix;
    };
    check_near(
        matrix(perspective, Forward::minus_z, opengl), glm::perspectiveRH_NO(fov, 1.5F, 0.5F, 8.0F)
    );
    check_near(
        matrix(perspective, Forward::minus_z, direct3d),
        glm::perspectiveRH_ZO(fov, 1.5F, 0.5F, 8.0F)
    );
    check_near(
        matrix(perspective, Forward::plus_z, opengl), glm::perspectiveLH_NO(fov, 1.5F, 0.5F, 8.0F)
    );
    check_near(
        matrix(perspective, Forward::plus_z, direct3d), glm::perspectiveLH_ZO(fov, 1.5F, 0.5F, 8.0F)
    );
    check_near(
        matrix(perspective, Forward::minus_z, reversed),
        glm::perspectiveRH_ZO(fov, 1.5F, 8.0F, 0.5F)
    );
    check_near(
        matrix(frustum, Forward::minus_z, opengl),
        glm::frustumRH_NO(-0.3F, 0.5F, -0.2F, 0.6F, 0.5F, 8.0F)
    );
    check_near(
        matrix(orthographic, Forward::minus_z, opengl),
        glm::orthoRH_NO(-half_width, half_width, -1.5F, 1.5F, 0.5F, 8.0F)
    );
    check_near(
        matrix(orthographic, Forward::plus_z, direct3d),
        glm::orthoLH_ZO(-half_width, half_width, -1.5F, 1.5F, 0.5F, 8.0F)
    );
}

TEST_CASE("the corners of an off-axis window land on the corners of NDC", "[unit][scene]") {
    // Closed form instead of GLM: the left-handed frustum of GLM 0.9.9 has the wrong sign in its
    // third column.
    for (const Forward forward : {Forward::minus_z, Forward::plus_z}) {
        const float z = forward == Forward::minus_z ? -frustum.near : frustum.near;
        const auto project =
            projection_transform(camera_of(frustum, forward), 1.0F, DepthConvention::opengl);
        const auto low = project(math::EyePosition{frustum.left, frustum.bottom, z, 1.0F});
        const auto high = project(math::EyePosition{frustum.right, frustum.top, z, 1.0F});
        CHECK(low.x / low.w == Approx(-1.0F));
        CHECK(low.y / low.w == Approx(-1.0F));
        CHECK(high.x / high.w == Approx(1.0F));
        CHECK(high.y / high.w == Approx(1.0F));
    }
}

TEST_CASE("near and far land on the ends of every depth convention", "[unit][scene]") {
    for (const Projection& projection : {perspective, orthographic, frustum}) {
        for (const Forward forward : {Forward::minus_z, Forward::plus_z}) {
            const Camera camera = camera_of(projection, forward);
            CHECK(ndc_z(camera, 0.5F, DepthConvention::opengl) == Approx(-1.0F).margin(1e-6));
            CHECK(ndc_z(camera, 8.0F, DepthConvention::opengl) == Approx(1.0F).margin(1e-6));
            CHECK(ndc_z(camera, 0.5F, DepthConvention::direct3d) == Approx(0.0F).margin(1e-6));
            CHECK(ndc_z(camera, 8.0F, DepthConvention::direct3d) == Approx(1.0F).margin(1e-6));
            CHECK(ndc_z(camera, 0.5F, DepthConvention::reversed) == Approx(1.0F).margin(1e-6));
            CHECK(ndc_z(camera, 8.0F, DepthConvention::reversed) == Approx(0.0F).margin(1e-6));
        }
    }
}

TEST_CASE("an identity projection leaves object coordinates alone", "[unit][scene]") {
    const Camera camera = camera_of({.kind = ProjectionKind::identity}, Forward::plus_z);
    CHECK(view_transform(camera).matrix == glm::mat4{1.0F});
    CHECK(projection_transform(camera, 2.0F, DepthConvention::reversed).matrix == glm::mat4{1.0F});
}
