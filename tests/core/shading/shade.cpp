#include "core/shading/shade.hpp"

#include "tests/support/catch.hpp"

using namespace hs;

namespace {

scene::Texture two_texels() {
    scene::Texture texture;
    texture.width = 2;
    texture.texels = {{0.5F, 1.0F, 0.0F, 1.0F}, {1.0F, 1.0F, 1.0F, 0.5F}};
    return texture;
}

} // namespace

TEST_CASE("an unlit fragment has the interpolated color", "[shading]") {
    math::Varyings varyings;
    varyings.set(0, glm::vec4{0.1F, 0.2F, 0.3F, 0.4F});
    const shading::ShadedFragment shaded = shading::shade({}, varyings);
    CHECK(shaded.color == glm::vec4{0.1F, 0.2F, 0.3F, 0.4F});
    CHECK_FALSE(shaded.texel.has_value());
    CHECK_FALSE(shaded.terms.has_value());
}

TEST_CASE("a texel multiplies the color, and is reported", "[shading]") {
    const scene::Texture texture = two_texels();
    shading::ShadingInputs in;
    in.texture = &texture;
    in.layout.uv = 4;
    math::Varyings varyings;
    varyings.set(0, glm::vec4{0.5F, 0.25F, 1.0F, 1.0F});
    varyings.set(4, glm::vec2{0.25F, 0.5F});
    const shading::ShadedFragment shaded = shading::shade(in, varyings);
    CHECK(shaded.color == glm::vec4{0.25F, 0.25F, 0.0F, 1.0F});
    REQUIRE(shaded.texel.has_value());
    CHECK(shaded.texel->i == 0);
    CHECK(shaded.texel->j == 0);
}

TEST_CASE("Phong shading lights the textured color with the interpolated normal", "[shading]") {
    shading::ShadingInputs in;
    in.shading = scene::Shading::phong;
    in.layout.normal = 4;
    in.layout.eye_position = 7;
    const shading::EyeLight light{.color = {0.5F, 0.5F, 0.5F}};
    in.lights = {&light, 1};
    math::Varyings varyings;
    varyings.set(0, glm::vec4{1.0F, 0.5F, 0.0F, 1.0F});
    varyings.set(4, glm::vec3{0.0F, 0.0F, 3.0F});
    varyings.set(7, glm::vec3{0.0F, 0.0F, -4.0F});
    const shading::ShadedFragment shaded = shading::shade(in, varyings);
    REQUIRE(shaded.terms.has_value());
    CHECK(shaded.terms->diffuse == glm::vec3{0.5F, 0.25F, 0.0F});
    CHECK(shaded.color == shaded.terms->color);
}

TEST_CASE("the viewer is at the eye, or a direction for orthographic cameras", "[shading]") {
    shading::ShadingInputs in;
    CHECK(shading::to_viewer(in, {0.0F, 0.0F, -4.0F}) == glm::vec3{0.0F, 0.0F, 1.0F});
    CHECK(shading::to_viewer(in, {3.0F, 0.0F, -4.0F}) == glm::vec3{-0.6F, 0.0F, 0.8F});
    CHECK(shading::to_viewer(in, {0.0F, 0.0F, 0.0F}) == glm::vec3{0.0F, 0.0F, 1.0F});
    in.orthographic = true;
    CHECK(shading::to_viewer(in, {3.0F, 0.0F, -4.0F}) == glm::vec3{0.0F, 0.0F, 1.0F});
    in.forward = 1.0F;
    CHECK(shading::to_viewer(in, {3.0F, 0.0F, 4.0F}) == glm::vec3{0.0F, 0.0F, -1.0F});
}
