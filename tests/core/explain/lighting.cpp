#include "core/explain/lighting.hpp"

#include "core/explain/numbers.hpp"
#include "core/scene/scene_file.hpp"
#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <string>

using namespace hs;

namespace {

/// A square that faces an orthographic eye, lit from 60° off its normal: n·l = 1/2, and h lies 30°
/// off the normal: n·h = √3/2. Shininess 2 makes its power 3/4.
constexpr std::string_view square = R"(
[settings]
size = [8, 8]
[camera]
eye = [0, 0, 2]
projection = { kind = "orthographic", height = 2.0, near = 0.1, far = 10.0 }
[[object]]
vertices = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]
polygons = [[0, 1, 2, 3]]
colors = [[0.5, 0.5, 1], [0.5, 0.5, 1], [0.5, 0.5, 1], [0.5, 0.5, 1]]
material = "shiny"
[[material]]
name = "shiny"
specular = [1, 0.5, 0]
shininess = 2
[[light]]
kind = "ambient"
color = [0.25, 0.5, 1]
[[light]]
to_light = [1.7320508, 0, 1]
color = [0.5, 1, 1]
[[light]]
to_light = [0, 0, -1]
)";
const glm::vec3 ambient{0.125F, 0.25F, 1.0F};
const glm::vec3 diffuse = 0.5F * glm::vec3{0.25F, 0.5F, 1.0F};
const glm::vec3 specular = 0.75F * glm::vec3{0.5F, 0.5F, 0.0F};

trace::Player at(const char* shading, std::string_view path) {
    const auto scene = scene::parse_scene(
        square, "square.toml", std::vector{scene::Assignment{"shading", shading}}
    );
    REQUIRE(scene);
    trace::Player player{trace::record(std::make_shared<const scene::Scene>(*scene)).value()};
    player.seek(trace::find_step(player.recording(), path).value());
    return player;
}

void check_near(const glm::vec3& a, const glm::vec3& b) {
    CHECK(glm::length(a - b) < 1.0e-6F);
}

void check_terms(const trace::LitPoint& point) {
    REQUIRE(point.lights.size() == 3);
    check_near(point.lights[0].ambient, ambient);
    CHECK(std::fabs(point.lights[1].n_dot_l - 0.5F) < 1.0e-6F);
    CHECK(std::fabs(point.lights[1].n_dot_h - std::sqrt(0.75F)) < 1.0e-6F);
    check_near(point.lights[1].diffuse, diffuse);
    check_near(point.lights[1].specular, specular);
    CHECK(point.lights[2].n_dot_l == -1.0F);
    check_near(point.lights[2].diffuse + point.lights[2].specular, glm::vec3{0.0F});
}

std::string rgb(const glm::vec3& c) {
    return explain::point(c.r, c.g, c.b);
}

} // namespace

TEST_CASE("every light's terms at a vertex are the closed form's", "[explain][lighting]") {
    const trace::Player player = at("gouraud", "vertex stage / vertex 2 / light");
    const trace::VertexDetail& vertex = *player.detail().vertex;
    REQUIRE(vertex.lit);
    check_terms(*vertex.lit);
    check_near(glm::vec3{vertex.work.terms->color}, ambient + diffuse + specular);
}

TEST_CASE("every light's terms at a fragment are the closed form's", "[explain][lighting]") {
    const trace::Player player = at("phong", "triangle 0 / fragment 5,5 / shade");
    const trace::FragmentDetail& fragment = *player.detail().fragment;
    REQUIRE(fragment.lit);
    check_terms(*fragment.lit);
    check_near(glm::vec3{fragment.shaded->color}, ambient + diffuse + specular);
}

TEST_CASE("the formulas of lighting end in the numbers that were computed", "[explain][lighting]") {
    const trace::Player player = at("phong", "triangle 0 / fragment 5,5 / shade");
    const auto list =
        explain::formulas(player.detail(), player.current(), player.recording().settings());
    REQUIRE(list.size() == 4);
    CHECK(list[0].value == explain::point(player.detail().fragment->shaded->color));
    CHECK(list[1].value == rgb(ambient));
    CHECK(
        list[2].value == rgb(player.detail().fragment->lit->lights[1].diffuse +
                             player.detail().fragment->lit->lights[1].specular)
    );
    CHECK(list[2].with_numbers.find("n·l = 0.5000") != std::string::npos);
    CHECK(list[2].with_numbers.find("0.8660^2.0000") != std::string::npos);
    CHECK(list[3].with_numbers.find("behind the surface") != std::string::npos);
}

TEST_CASE(
    "per vertex, a fragment's color is the mix of its corners' colors", "[explain][lighting]"
) {
    const trace::Player player = at("gouraud", "triangle 0 / fragment 5,5 / shade");
    const auto list =
        explain::formulas(player.detail(), player.current(), player.recording().settings());
    REQUIRE(list.size() == 1);
    const auto& weights = player.detail().fragment->fragment.barycentric_clip;
    glm::vec4 mixed{0.0F};
    for (unsigned k = 0; k < 3; ++k) {
        mixed += weights[k] * player.detail().triangle->corners[k].work.varyings.color();
    }
    CHECK(glm::length(mixed - player.detail().fragment->shaded->color) < 1.0e-6F);
    CHECK(list[0].value == explain::point(player.detail().fragment->shaded->color));
}

TEST_CASE(
    "a highlight between the vertices is seen per fragment, and missed per vertex",
    "[explain][lighting]"
) {
    // From a near eye the highlight stands in the middle of the square, far from every vertex
    const auto brightest = [](const char* shading) {
        const std::vector<scene::Assignment> changes{
            {"shading", shading},
            {"camera.eye", "[0, 0, 1.5]"},
            {"camera.projection", "{ kind = \"perspective\", fov_y = 60, near = 0.1, far = 9 }"},
            {"material.0.shininess", "200"},
            {"light.1.to_light", "[0, 0, 1]"}};
        const auto scene = scene::parse_scene(square, "square.toml", changes);
        REQUIRE(scene);
        trace::Player player{trace::record(std::make_shared<const scene::Scene>(*scene)).value()};
        return player.color({4, 4}).r;
    };
    const float without = (0.25F + 0.5F) * 0.5F; // ambient and diffuse at n·l = 1
    CHECK(std::fabs(brightest("gouraud") - without) < 2.0F / 255.0F);
    CHECK(brightest("phong") > without + 0.35F);
}
