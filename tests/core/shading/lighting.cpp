#include "core/shading/lighting.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace hs;

namespace {

const glm::vec3 white{1.0F};

shading::EyeLight directional(const glm::vec3& to_light, const glm::vec3& color) {
    return {
        .kind = scene::LightKind::directional,
        .to_light = glm::normalize(to_light),
        .color = color};
}

/// A point straight ahead whose normal faces the eye.
shading::SurfacePoint facing_point() {
    return {
        .position = {0.0F, 0.0F, -5.0F},
        .normal = {0.0F, 0.0F, 1.0F},
        .to_viewer = {0.0F, 0.0F, 1.0F},
        .color = {0.5F, 0.25F, 1.0F, 0.75F},
        .specular = {0.0F, 0.0F, 0.0F},
        .shininess = 32.0F};
}

shading::LightingTerms lit(const shading::SurfacePoint& point, const shading::EyeLight& light) {
    return shading::light_surface(point, {&light, 1});
}

float largest_difference(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z});
}

} // namespace

TEST_CASE("ambient light is its color times the surface's", "[shading]") {
    shading::EyeLight light;
    light.kind = scene::LightKind::ambient;
    light.color = {0.5F, 1.0F, 0.25F};
    const shading::LightingTerms terms = lit(facing_point(), light);
    CHECK(terms.ambient == glm::vec3{0.25F, 0.25F, 0.25F});
    CHECK(terms.diffuse == glm::vec3{0.0F});
    CHECK(terms.color == glm::vec4{0.25F, 0.25F, 0.25F, 0.75F});
}

TEST_CASE("diffuse light falls with the cosine of the angle", "[shading]") {
    for (const float degrees : {0.0F, 30.0F, 60.0F, 89.0F}) {
        const float angle = degrees * 3.14159265F / 180.0F;
        const auto light = directional({std::sin(angle), 0.0F, std::cos(angle)}, white);
        const shading::LightingTerms terms = lit(facing_point(), light);
        INFO(degrees << " degrees");
        CHECK(
            largest_difference(terms.diffuse, std::cos(angle) * glm::vec3{0.5F, 0.25F, 1.0F}) <
            1.0e-6F
        );
    }
}

TEST_CASE("light from behind the surface adds nothing", "[shading]") {
    shading::SurfacePoint point = facing_point();
    point.specular = white;
    for (const glm::vec3& from :
         {glm::vec3{0, 0, -1}, glm::vec3{1, 0, -0.1F}, glm::vec3{1, 0, 0}}) {
        CHECK(lit(point, directional(from, white)).color == glm::vec4{0.0F, 0.0F, 0.0F, 0.75F});
    }
}

TEST_CASE("the highlight is (n · h)^shininess times both colors", "[shading]") {
    shading::SurfacePoint point = facing_point();
    point.specular = {1.0F, 0.5F, 0.25F};
    point.shininess = 8.0F;
    const float half_angle = 0.2F; // light at 0.4 from the normal, viewer on it
    const auto light =
        directional({std::sin(2.0F * half_angle), 0.0F, std::cos(2.0F * half_angle)}, white);
    const glm::vec3 expected = std::pow(std::cos(half_angle), 8.0F) * point.specular;
    CHECK(largest_difference(lit(point, light).specular, expected) < 1.0e-6F);
}

TEST_CASE("a point light shines from where it stands, however far", "[shading]") {
    shading::EyeLight light;
    light.kind = scene::LightKind::point;
    light.position = {3.0F, 0.0F, -1.0F}; // (3, 0, 4) from the point: cosine 4/5
    CHECK(
        largest_difference(
            lit(facing_point(), light).diffuse, 0.8F * glm::vec3{0.5F, 0.25F, 1.0F}
        ) < 1.0e-6F
    );
    light.position = {3000.0F, 0.0F, 3995.0F};
    CHECK(
        largest_difference(
            lit(facing_point(), light).diffuse, 0.8F * glm::vec3{0.5F, 0.25F, 1.0F}
        ) < 1.0e-6F
    );
}

TEST_CASE("the length of the normal does not matter, and a zero normal is not lit", "[shading]") {
    const auto light = directional({1.0F, 2.0F, 3.0F}, white);
    shading::SurfacePoint point = facing_point();
    const glm::vec4 unit = lit(point, light).color;
    point.normal *= 8.0F;
    CHECK(lit(point, light).color == unit);
    point.normal = glm::vec3{0.0F};
    CHECK(lit(point, light).color == glm::vec4{0.0F, 0.0F, 0.0F, 0.75F});
}

TEST_CASE("the color is the sum of the terms, and of the lights", "[shading]") {
    tests::Random random(7);
    shading::SurfacePoint point = facing_point();
    point.specular = {0.25F, 0.5F, 0.125F};
    for (int i = 0; i < 100; ++i) {
        std::array<shading::EyeLight, 3> lights;
        glm::vec3 sum{0.0F};
        for (shading::EyeLight& light : lights) {
            light = directional({random.between(-1, 1), random.between(-1, 1), 0.5F}, white);
            light.kind = static_cast<scene::LightKind>(random.below(3));
            sum += glm::vec3{lit(point, light).color};
        }
        const shading::LightingTerms terms = shading::light_surface(point, lights);
        CHECK(glm::vec3{terms.color} == terms.ambient + terms.diffuse + terms.specular);
        CHECK(largest_difference(glm::vec3{terms.color}, sum) < 1.0e-5F);
    }
}

TEST_CASE("lights are taken to eye space: directions turn, positions also move", "[shading]") {
    glm::mat4 view{1.0F};
    view[0] = {0.0F, 0.0F, -1.0F, 0.0F}; // a quarter turn around y
    view[2] = {1.0F, 0.0F, 0.0F, 0.0F};
    view[3] = {10.0F, 20.0F, 30.0F, 1.0F};
    scene::Light light;
    light.to_light = {0.0F, 0.0F, 5.0F};
    light.position = {1.0F, 2.0F, 3.0F};
    const std::vector<shading::EyeLight> eye = shading::lights_in_eye_space({&light, 1}, view);
    REQUIRE(eye.size() == 1);
    CHECK(eye[0].to_light == glm::vec3{1.0F, 0.0F, 0.0F});
    CHECK(eye[0].position == glm::vec3{13.0F, 22.0F, 29.0F});
}
