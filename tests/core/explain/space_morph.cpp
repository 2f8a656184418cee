#include "core/explain/space_morph.hpp"

#include "core/scene/camera.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>

#include <random>

using namespace hs;

namespace {

struct Case {
    scene::Camera camera;
    scene::DepthConvention convention = scene::DepthConvention::opengl;

    [[nodiscard]] glm::mat4 projection() const {
        return scene::projection_transform(camera, 1.5F, convention).matrix;
    }
    [[nodiscard]] explain::DepthDirections directions() const {
        return {scene::forward_sign(camera), convention != scene::DepthConvention::reversed};
    }
    [[nodiscard]] std::optional<glm::vec3> at(const glm::vec3& eye, float place) const {
        const glm::vec4 point{eye, 1.0F};
        return explain::morphed(point, projection() * point, directions(), place);
    }
};

std::vector<Case> cases() {
    std::vector<Case> list;
    for (const auto convention :
         {scene::DepthConvention::opengl,
          scene::DepthConvention::direct3d,
          scene::DepthConvention::reversed}) {
        for (const auto forward : {scene::Forward::minus_z, scene::Forward::plus_z}) {
            for (const auto kind :
                 {scene::ProjectionKind::perspective,
                  scene::ProjectionKind::orthographic,
                  scene::ProjectionKind::frustum}) {
                Case one;
                one.convention = convention;
                one.camera.forward = forward;
                one.camera.projection.kind = kind;
                one.camera.projection.near = 0.5F;
                list.push_back(one);
            }
        }
    }
    return list;
}

/// Points inside the view volume's depth range, in front of the eye.
glm::vec3 in_front(const Case& c, std::mt19937& random) {
    std::uniform_real_distribution<float> across{-2.0F, 2.0F};
    std::uniform_real_distribution<float> away{0.6F, 9.0F};
    return {across(random), across(random), scene::forward_sign(c.camera) * away(random)};
}

} // namespace

TEST_CASE("the way from eye space to NDC begins, passes and ends exactly", "[explain]") {
    std::mt19937 random{7};
    for (const Case& c : cases()) {
        for (int i = 0; i < 50; ++i) {
            const glm::vec3 eye = in_front(c, random);
            const glm::vec4 clip = c.projection() * glm::vec4{eye, 1.0F};
            const float away = scene::forward_sign(c.camera) * eye.z;
            CHECK(c.at(eye, 0.0F) == glm::vec3{eye.x, eye.y, -away});
            CHECK(c.at(eye, 1.0F) == glm::vec3{clip.x, clip.y, -clip.w});
            const glm::vec3 ndc = glm::vec3{clip} * (1.0F / clip.w);
            const bool reversed = c.convention == scene::DepthConvention::reversed;
            CHECK(c.at(eye, 2.0F) == glm::vec3{ndc.x, ndc.y, reversed ? ndc.z : -ndc.z});
        }
    }
}

TEST_CASE("straight lines stay straight all the way", "[explain]") {
    std::mt19937 random{8};
    for (const Case& c : cases()) {
        for (const float place : {0.25F, 0.5F, 1.0F, 1.1F, 1.5F, 1.9F, 2.0F}) {
            const glm::vec3 a = in_front(c, random);
            const glm::vec3 b = in_front(c, random);
            const auto from = c.at(a, place);
            const auto to = c.at(b, place);
            const auto between = c.at(a * 0.7F + b * 0.3F, place);
            REQUIRE((from && to && between));
            const glm::vec3 line = glm::normalize(*to - *from);
            const glm::vec3 across = *between - *from;
            CHECK(glm::length(across - line * glm::dot(across, line)) < 1.0e-4F);
        }
    }
}

TEST_CASE("what is farther stays farther all the way", "[explain]") {
    for (const Case& c : cases()) {
        const bool flat = c.camera.projection.kind == scene::ProjectionKind::orthographic;
        const float forward = scene::forward_sign(c.camera);
        for (float place = 0.0F; place <= 2.0F; place += 0.125F) {
            float before = 1.0e9F;
            for (float away = 0.6F; away < 9.0F; away += 0.3F) {
                const auto drawn = c.at({0.3F, 0.2F, forward * away}, place);
                REQUIRE(drawn);
                // w is 1 everywhere under a parallel projection: clip space is flat
                CHECK((flat && place == 1.0F ? drawn->z <= before : drawn->z < before));
                before = drawn->z;
            }
        }
    }
}

TEST_CASE("what lies behind the eye has no place after the divide", "[explain]") {
    const Case c;
    CHECK_FALSE(c.at({0.0F, 0.0F, 1.0F}, 2.0F));
    CHECK_FALSE(c.at({0.0F, 0.0F, 0.0F}, 2.0F));
    CHECK(c.at({0.0F, 0.0F, 1.0F}, 0.5F));
}
