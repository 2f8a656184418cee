#include "core/explain/normal_story.hpp"

#include "core/scene/scene_file.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>

#include <cmath>

using namespace hs;

namespace {

std::shared_ptr<const trace::Recording>
recorded(const std::string& transform, const std::vector<scene::Assignment>& changes = {}) {
    const std::string text = R"(
[settings]
shading = "gouraud"
[camera]
projection = { kind = "orthographic", height = 4.0, near = 0.1, far = 10.0 }
[[object]]
vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
polygons = [[0, 1, 2], [0, 2, 3]]
normals = [[0.6, 0.8, 0], [0, 0, 1], [0, 0, 1], [0, 0, 1]]
transform = )" + transform;
    const auto scene = scene::parse_scene(text, "normals.toml", changes);
    REQUIRE(scene);
    return trace::record(std::make_shared<const scene::Scene>(*scene)).value();
}

} // namespace

TEST_CASE("under a non-uniform scale the wrong normal leans by the closed form", "[explain]") {
    const auto recording = recorded("[{ scale = [2, 1, 1] }]");
    const auto story = explain::normal_story(*recording, 0, 0);
    REQUIRE(story);
    // The normal (3, 4)/5 has the tangent ±(4, −3)/5. Scaled: (±8, ∓3)/√73 and (6, 4)/√52
    const float expected = (6.0F * 8.0F - 4.0F * 3.0F) / std::sqrt(52.0F * 73.0F);
    CHECK(std::fabs(std::fabs(story->dot_by_matrix) - expected) < 1.0e-6F);
    CHECK(std::fabs(story->dot_before) < 1.0e-6F);
    CHECK(std::fabs(story->dot_by_inverse_transpose) < 1.0e-6F);
    // The inverse transpose takes (3, 4) to (3/2, 4), the direction (3, 8)
    CHECK(glm::length(story->by_inverse_transpose - glm::normalize(glm::vec3{3, 8, 0})) < 1.0e-6F);
    CHECK(story->executed);
}

TEST_CASE("rotation and uniform scale move normals as they move points", "[explain]") {
    const auto recording =
        recorded("[{ rotate = { axis = [1, 2, 3], degrees = 40 } }, { scale = [3, 3, 3] }]");
    const auto story = explain::normal_story(*recording, 0, 0);
    REQUIRE(story);
    CHECK(std::fabs(story->dot_by_matrix) < 1.0e-6F);
    CHECK(glm::length(story->by_matrix - story->by_inverse_transpose) < 1.0e-6F);
}

TEST_CASE("the inverse transpose stays perpendicular whatever the matrix", "[explain]") {
    for (const char* const transform :
         {"[{ scale = [5, 0.2, 1] }]",
          "[{ scale = [-1, 3, 0.5] }]",
          "[{ rotate = { axis = [0, 1, 1], degrees = 50 } }, { scale = [1, 7, 2] }]",
          "[{ matrix = [[1, 2, 0, 0], [0, 1, 0.5, 3], [0, 0, 1, 0], [0, 0, 0, 1]] }]"}) {
        INFO(transform);
        const auto recording = recorded(transform);
        for (std::uint32_t vertex = 0; vertex < 4; ++vertex) {
            const auto story = explain::normal_story(*recording, 0, vertex);
            REQUIRE(story);
            CHECK(std::fabs(story->dot_by_inverse_transpose) < 1.0e-5F);
        }
        CHECK(std::fabs(explain::normal_story(*recording, 0, 0)->dot_by_matrix) > 0.1F);
    }
}

TEST_CASE("a seeded fault is noticed, and what is flat has no story", "[explain]") {
    const auto faulty = recorded("[{ scale = [2, 1, 1] }]", {{"fault", "normals-like-points"}});
    CHECK_FALSE(explain::normal_story(*faulty, 0, 0)->executed);
    const auto flat = recorded("[{ scale = [0, 1, 1] }]");
    CHECK_FALSE(explain::normal_story(*flat, 0, 0));
}
