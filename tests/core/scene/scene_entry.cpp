#include "core/scene/scene_entry.hpp"

#include "tests/support/catch.hpp"

#include <string>
#include <vector>

using namespace hs;
using namespace hs::scene;

namespace {

constexpr const char* three_objects = R"(
[camera]
eye = [0.1, 1, 5]
projection = { kind = "perspective", fov_y = 50, near = 0.3, far = 77.7 }
[[material]]
name = "clay"
diffuse = [0.8, 0.5, 0.4]
[[material]]
name = "slate"
[[object]]
name = "ball"
shape = { kind = "cube" }
material = "clay"
transform = [{ translate = [1, 0.2, 3] }, { rotate = { axis = [0, 1, 0.1], degrees = 33.3 } }]
[[object]]
name = "plain"
shape = { kind = "cube" }
[[object]]
name = "sheared"
shape = { kind = "cube" }
transform = [{ scale = [1, 2, 0.7] }, { matrix = [[1, 0.5, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]] }]
)";

Scene parsed(std::vector<Assignment> assignments = {}) {
    Result<Scene> scene = parse_scene(three_objects, "three.toml", assignments);
    REQUIRE(scene);
    return std::move(*scene);
}

bool same_placement(const Scene& a, const Scene& b) {
    bool same = a.camera == b.camera && a.objects.size() == b.objects.size();
    for (std::size_t i = 0; same && i < a.objects.size(); ++i) {
        same = object_to_world(a.objects[i]) == object_to_world(b.objects[i]) &&
               a.objects[i].material == b.objects[i].material;
    }
    return same;
}

std::string complaint_about(std::string path, std::string value) {
    Scene scene = parsed();
    return change_entry(scene, {std::move(path), std::move(value)}).value_or("");
}

} // namespace

TEST_CASE("an entry changed in memory is an entry changed in the file", "[unit][scene]") {
    const std::vector<Assignment> changes{
        {"camera.eye", "[0.5, 0, 3]"},
        {"camera.eye.0", "2"},
        {"camera.forward", "+z"},
        {"camera.projection.fov_y", "20.5"},
        {"camera.projection.near", "0.1"},
        {"camera.projection", "{ kind = \"orthographic\", height = 3.5 }"},
        {"object.0.transform.0.translate", "[0, 0.3, 0]"},
        {"object.0.transform.1.rotate.degrees", "-12"},
        {"object.0.transform", "[]"},
        {"object.1.transform", "[{ translate = [0, 1, 0] }]"},
        {"object.2.transform.1.matrix.0", "[2, 0, 0, 0.1]"},
        {"object.0.material", "slate"}};
    for (const Assignment& change : changes) {
        INFO(change.path << " = " << change.value);
        Scene scene = parsed();
        REQUIRE(change_entry(scene, change) == std::nullopt);
        CHECK(same_placement(scene, parsed({change})));
        CHECK_FALSE(same_placement(scene, parsed()));
    }
}

TEST_CASE("what is printed of an entry reads back the same", "[unit][scene]") {
    for (const char* const path :
         {"camera.eye",
          "camera.up",
          "camera.forward",
          "camera.projection.far",
          "camera.projection",
          "object.0.transform",
          "object.ball.material",
          "object.sheared.transform"}) {
        Scene scene = parsed();
        const std::string text = print_entry(scene, path);
        INFO(path << " = " << text);
        CHECK_FALSE(text.empty());
        REQUIRE(change_entry(scene, {path, text}) == std::nullopt);
        CHECK(same_placement(scene, parsed()));
    }
    CHECK(print_entry(parsed(), "camera.lens").empty());
    CHECK(print_entry(parsed(), "object.7.transform").empty());
}

TEST_CASE("an object is meant by its number or by its name", "[unit][scene]") {
    Scene by_name = parsed();
    REQUIRE_FALSE(change_entry(by_name, {"object.plain.transform", "[{ scale = [2, 2, 2] }]"}));
    CHECK(same_placement(by_name, parsed({{"object.1.transform", "[{ scale = [2, 2, 2] }]"}})));
}

TEST_CASE("another kind of projection keeps what both kinds know", "[unit][scene]") {
    Scene scene = parsed();
    REQUIRE_FALSE(change_entry(scene, {"camera.projection.kind", "orthographic"}));
    CHECK(scene.camera.projection.kind == ProjectionKind::orthographic);
    CHECK(scene.camera.projection.near == 0.3F);
    CHECK(scene.camera.projection.far == 77.7F);
}

TEST_CASE("what cannot be changed is refused in one sentence", "[unit][scene]") {
    const auto says = [](const std::string& path, const std::string& value, std::string_view words
                      ) {
        const std::string complaint = complaint_about(path, value);
        INFO(path << " = " << value << ": " << complaint);
        return complaint.find(words) != std::string::npos;
    };
    CHECK(says("camera.eye", "3", "eye of camera must be"));
    CHECK(says("camera.eye", "[0, 0, 0]", "the same point"));
    CHECK(says("camera.fov", "30", "fov"));
    CHECK(says("camera.projection.fov_y", "180", "between 0 and 180"));
    CHECK(says("camera.projection.near", "100", "far of projection"));
    CHECK(says("camera", "3", "camera is a table"));
    CHECK(says("camera.projection.kind", "fisheye", "kind"));
    CHECK(says("object.bal.transform", "[]", "did you mean"));
    CHECK(says("object.7.transform", "[]", "there is no object \"7\""));
    CHECK(says("object.ball.translate", "[1, 0, 0]", "transform and material"));
    CHECK(says("object.ball.mesh", "other.obj", "transform and material"));
    CHECK(says("object.ball.transform.5.translate", "[1, 0, 0]", "there is no 5"));
    CHECK(says("object.ball.transform", "[{ bend = 3 }]", "bend"));
    CHECK(says("object.ball.material", "gold", "there is no material"));
    CHECK(says("object.ball", "3", "is a table"));
    CHECK(says("object", "3", "there is no object"));
}
