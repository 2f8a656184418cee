#include "core/explain/projection_ladder.hpp"

#include "tests/support/catch.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <random>

using namespace hs;
using scene::DepthConvention;
using scene::Forward;
using scene::ProjectionKind;

namespace {

constexpr float aspect = 1.5F;

scene::Camera camera(ProjectionKind kind, Forward forward = Forward::minus_z) {
    scene::Camera c;
    c.forward = forward;
    c.projection = {
        .kind = kind,
        .fov_y = 50.0F,
        .height = 3.0F,
        .left = -0.2F,
        .right = 0.7F,
        .bottom = -0.4F,
        .top = 0.3F,
        .near = 0.5F,
        .far = 20.0F};
    return c;
}

void check_equal(const glm::mat4& a, const glm::mat4& b) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            INFO("row " << row << " column " << column);
            CHECK(a[column][row] == Approx(b[column][row]).epsilon(1.0e-5).margin(1.0e-6));
        }
    }
}

glm::vec3 in_front(const scene::Camera& c, std::mt19937& random) {
    std::uniform_real_distribution<float> across{-3.0F, 3.0F};
    std::uniform_real_distribution<float> away{0.5F, 20.0F};
    return {across(random), across(random), scene::forward_sign(c) * away(random)};
}

} // namespace

TEST_CASE("the ladder's last rung is GLM's frustum, perspective and ortho", "[explain]") {
    const glm::vec3 point{0.3F, -0.2F, -4.0F};
    const auto last = [&](ProjectionKind kind, DepthConvention convention) {
        return explain::projection_ladder(camera(kind), aspect, convention, point).back().matrix;
    };
    const scene::Projection p = camera(ProjectionKind::frustum).projection;
    check_equal(
        last(ProjectionKind::frustum, DepthConvention::opengl),
        glm::frustumRH_NO(p.left, p.right, p.bottom, p.top, p.near, p.far)
    );
    check_equal(
        last(ProjectionKind::frustum, DepthConvention::direct3d),
        glm::frustumRH_ZO(p.left, p.right, p.bottom, p.top, p.near, p.far)
    );
    // Reversed: 1 − z_ndc, that is w − z
    glm::mat4 turned{1.0F};
    turned[2][2] = -1.0F;
    turned[3][2] = 1.0F;
    check_equal(
        last(ProjectionKind::frustum, DepthConvention::reversed),
        turned * glm::frustumRH_ZO(p.left, p.right, p.bottom, p.top, p.near, p.far)
    );
}

TEST_CASE("field of view and aspect are a symmetric l, r, b, t", "[explain]") {
    const scene::Projection p = camera(ProjectionKind::perspective).projection;
    const explain::FrustumLimits v = explain::frustum_limits(p, aspect);
    check_equal(
        glm::frustumRH_NO(v.left, v.right, v.bottom, v.top, v.near, v.far),
        glm::perspectiveRH_NO(glm::radians(p.fov_y), aspect, p.near, p.far)
    );
    const scene::Projection o = camera(ProjectionKind::orthographic).projection;
    const explain::FrustumLimits box = explain::frustum_limits(o, aspect);
    check_equal(
        glm::orthoRH_NO(box.left, box.right, box.bottom, box.top, box.near, box.far),
        explain::projection_ladder(
            camera(ProjectionKind::orthographic), aspect, DepthConvention::opengl, {}
        )
            .back()
            .matrix
    );
}

TEST_CASE("each rung leaves of depth what it says", "[explain]") {
    std::mt19937 random{3};
    for (const Forward forward : {Forward::minus_z, Forward::plus_z}) {
        const scene::Camera c = camera(ProjectionKind::perspective, forward);
        for (int i = 0; i < 100; ++i) {
            const glm::vec3 p = in_front(c, random);
            const float d = scene::forward_sign(c) * p.z;
            const auto ladder = explain::projection_ladder(c, aspect, DepthConvention::opengl, p);
            REQUIRE(ladder.size() == 3);
            for (const explain::ProjectionRung& rung : ladder) {
                REQUIRE(rung.divided);
            }
            for (const std::size_t rung : {0U, 1U}) {
                CHECK(ladder[rung].divided->x == Approx(p.x / d));
                CHECK(ladder[rung].divided->y == Approx(p.y / d));
            }
            CHECK(ladder[0].divided->z == 1.0F);
            CHECK(ladder[1].divided->z == Approx(1.0F / d));
            const float n = c.projection.near;
            const float f = c.projection.far;
            CHECK(
                ladder[2].divided->z ==
                Approx((f + n) / (f - n) - 2.0F * f * n / (f - n) / d).margin(1.0e-5)
            );
        }
    }
    const auto parallel = explain::projection_ladder(
        camera(ProjectionKind::orthographic), aspect, DepthConvention::opengl, {1.0F, 2.0F, -3.0F}
    );
    REQUIRE(parallel.size() == 2);
    CHECK(parallel[0].divided == glm::vec3{1.0F, 2.0F, 0.0F});
}

TEST_CASE("near and far are the ends of every convention's range", "[explain]") {
    for (const ProjectionKind kind :
         {ProjectionKind::perspective, ProjectionKind::orthographic, ProjectionKind::frustum}) {
        for (const Forward forward : {Forward::minus_z, Forward::plus_z}) {
            const scene::Camera c = camera(kind, forward);
            const auto at = [&](float distance) {
                const float z = scene::forward_sign(c) * distance;
                return explain::depth_in_conventions(c, aspect, {0.1F, 0.1F, z}).value();
            };
            const auto near = at(c.projection.near);
            const auto far = at(c.projection.far);
            CHECK(near[0].z_ndc == Approx(-1.0F));
            CHECK(far[0].z_ndc == Approx(1.0F));
            CHECK(near[1].z_ndc == Approx(0.0F).margin(1.0e-6));
            CHECK(far[1].z_ndc == Approx(1.0F));
            CHECK(near[2].z_ndc == Approx(1.0F));
            CHECK(far[2].z_ndc == Approx(0.0F).margin(1.0e-6));
            CHECK(near[0].depth == Approx(0.0F).margin(1.0e-6));
            for (const float distance : {0.6F, 1.0F, 3.0F, 15.0F}) {
                const auto list = at(distance);
                CHECK(list[0].depth == Approx(list[1].depth).margin(1.0e-6));
                CHECK(list[2].depth == Approx(1.0F - list[1].depth).margin(1.0e-6));
                for (const explain::ConventionDepth& one : list) {
                    const float z = scene::forward_sign(c) * distance;
                    CHECK(one.z_clip == Approx(one.a * z + one.b).margin(1.0e-6));
                }
            }
        }
    }
}

TEST_CASE("the long way by hand ends where the matrix does", "[explain]") {
    std::mt19937 random{5};
    for (const ProjectionKind kind :
         {ProjectionKind::perspective, ProjectionKind::orthographic, ProjectionKind::frustum}) {
        for (const Forward forward : {Forward::minus_z, Forward::plus_z}) {
            const scene::Camera c = camera(kind, forward);
            for (int i = 0; i < 100; ++i) {
                const glm::vec3 p = in_front(c, random);
                const auto hand = explain::project_by_hand(c, 300, 200, p);
                const auto ladder =
                    explain::projection_ladder(c, aspect, DepthConvention::opengl, p);
                REQUIRE(hand);
                const glm::vec3 ndc = ladder.back().divided.value();
                CHECK(hand->ndc.x == Approx(ndc.x).epsilon(1.0e-4).margin(1.0e-5));
                CHECK(hand->ndc.y == Approx(ndc.y).epsilon(1.0e-4).margin(1.0e-5));
                CHECK(
                    hand->raster.x == Approx((ndc.x + 1.0F) * 150.0F).epsilon(1.0e-4).margin(0.01)
                );
                CHECK(
                    hand->raster.y == Approx((1.0F - ndc.y) * 100.0F).epsilon(1.0e-4).margin(0.01)
                );
            }
        }
    }
    const scene::Camera c = camera(ProjectionKind::perspective);
    CHECK_FALSE(explain::project_by_hand(c, 300, 200, {0.0F, 0.0F, 1.0F}));
    CHECK_FALSE(explain::project_by_hand(c, 300, 200, {0.0F, 0.0F, 0.0F}));
}

TEST_CASE("every entry that is not 0 is explained, with the value it has", "[explain]") {
    for (const ProjectionKind kind :
         {ProjectionKind::perspective, ProjectionKind::orthographic, ProjectionKind::frustum}) {
        for (const auto convention :
             {DepthConvention::opengl, DepthConvention::direct3d, DepthConvention::reversed}) {
            for (const Forward forward : {Forward::minus_z, Forward::plus_z}) {
                const scene::Camera c = camera(kind, forward);
                glm::mat4 m = scene::projection_transform(c, aspect, convention).matrix;
                for (const explain::MatrixEntry& e :
                     explain::matrix_entries(c, aspect, convention)) {
                    CHECK(e.value == m[e.column][e.row]);
                    CHECK_FALSE(e.symbolic.empty());
                    CHECK_FALSE(e.meaning.empty());
                    m[e.column][e.row] = 0.0F;
                }
                CHECK(m == glm::mat4{0.0F});
            }
        }
    }
    CHECK(explain::matrix_entries(camera(ProjectionKind::identity), aspect, {}).empty());
}
