#include "core/scene/scene_file.hpp"

#include "core/scene/shapes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace hs;
using namespace hs::scene;

namespace {

constexpr const char* small_scene = R"(
name = "small"

[settings]
size = [32, 16]
depth.test = "lequal"
clip.planes = [[1, 0, 0, 0.5]]

[camera]
eye = [0, 1, 5]
projection = { kind = "orthographic", height = 4.0 }

[[material]]
name = "clay"
diffuse = [0.8, 0.5, 0.4]

[[light]]
kind = "point"
position = [1, 2, 3]

[[object]]
name = "triangle"
vertices = [[-1, -1, 0], [1, -1, 0, 2], [0, 1, 0]]
polygons = [[0, 1, 2]]
colors = [[1, 0, 0], [0, 1, 0, 0.5], [0, 0, 1]]
material = "clay"
transform = [{ translate = [1, 2, 3] }, { rotate = { axis = [0, 1, 0], degrees = 30 } }]
settings = { depth.write = false, cull = "back" }

[[object]]
shape = { kind = "cube" }
fit = true
)";

Result<Scene> parse(std::string_view text, std::vector<Assignment> assignments = {}) {
    return parse_scene(text, "test.toml", assignments);
}

Assignment set(std::string_view text) {
    Result<Assignment> assignment = parse_assignment(text);
    REQUIRE(assignment);
    return *assignment;
}

std::string first_error(const Result<Scene>& scene) {
    return scene ? "no error" : scene.diagnostics().front().to_string();
}

} // namespace

TEST_CASE("a scene arrives as it is written", "[unit][scene]") {
    const Result<Scene> scene = parse(small_scene);
    REQUIRE(scene);
    CHECK(scene->name == "small");
    CHECK(scene->file == "test.toml");
    CHECK(scene->settings.width == 32);
    CHECK(scene->settings.height == 16);
    CHECK(scene->settings.depth_test() == CompareOp::lequal);
    CHECK(scene->settings.clip_planes == std::vector<glm::vec4>{{1, 0, 0, 0.5}});
    CHECK(scene->camera.eye == glm::vec3{0, 1, 5});
    CHECK(scene->camera.projection.kind == ProjectionKind::orthographic);
    CHECK(scene->camera.projection.height == 4.0F);
    CHECK(scene->materials.at(0).diffuse == glm::vec4{0.8F, 0.5F, 0.4F, 1.0F});
    CHECK(scene->lights.at(0).kind == LightKind::point);
    CHECK(scene->lights.at(0).position == glm::vec3{1, 2, 3});
    REQUIRE(scene->objects.size() == 2);
    const Object& triangle = scene->objects[0];
    CHECK(triangle.name == "triangle");
    CHECK(triangle.material == 0);
    CHECK(triangle.mesh->positions[1] == glm::vec4{1, -1, 0, 2});
    CHECK(triangle.mesh->colors[1] == glm::vec4{0, 1, 0, 0.5});
    CHECK(triangle.mesh->triangles == std::vector<TriangleIndices>{{0, 1, 2}});
    CHECK(triangle.transform.at(1).degrees == 30.0F);
    CHECK_FALSE(object_settings(*scene, triangle).depth_write);
    CHECK(object_settings(*scene, triangle).cull == CullFace::back);
    CHECK(scene->objects[1].name == "object 1");
    CHECK(scene->objects[1].mesh->triangles.size() == 12);
    CHECK(scene->objects[1].mesh->positions[0].x == Approx(-0.57735F));
}

TEST_CASE("an empty file is an empty scene with the default settings", "[unit][scene]") {
    const Result<Scene> scene = parse("");
    REQUIRE(scene);
    CHECK(scene->objects.empty());
    CHECK(scene->settings == Settings{});
    CHECK(scene->camera == Camera{});
}

TEST_CASE("every entry of a scene can be assigned", "[unit][scene]") {
    const Result<Scene> scene = parse(
        small_scene,
        {set("size=[8, 8]"),
         set("depth.test = always"),
         set("settings.cull=\"front\""),
         set("camera.eye=[0, 0, 9]"),
         set("camera.target.1=0.5"),
         set("camera.target=[0, 0.25, 0]"),
         set("object.0.transform.1.rotate.degrees=45"),
         set("object.1.shape.kind=torus"),
         set("object.1.settings.depth.write=false"),
         set("camera.projection.kind=perspective"),
         set("camera.projection={ fov_y = 60 }"),
         set("name=a \"quoted\" name")}
    );
    // camera.target did not exist when its entry 1 was assigned.
    CHECK(first_error(scene) == "--set camera.target.1: there is no 1 in camera.target");

    const Result<Scene> good = parse(
        small_scene,
        {set("size=[8, 8]"),
         set("depth.test = always"),
         set("settings.cull=\"front\""),
         set("camera.eye.2=9"),
         set("object.0.transform.1.rotate.degrees=45"),
         set("object.1.shape.kind=torus"),
         set("object.1.settings.depth.write=false"),
         set("camera.projection={ fov_y = 60 }"),
         set("name=a \"quoted\" name")}
    );
    REQUIRE(first_error(good) == "no error");
    CHECK(good->settings.width == 8);
    CHECK(good->settings.depth_test() == CompareOp::always);
    CHECK(good->settings.cull == CullFace::front);
    CHECK(good->camera.eye == glm::vec3{0, 1, 9});
    CHECK(good->camera.projection.fov_y == 60.0F);
    CHECK(good->objects[0].transform[1].degrees == 45.0F);
    CHECK(good->objects[1].mesh->triangles.size() == 1024);
    CHECK_FALSE(object_settings(*good, good->objects[1]).depth_write);
    CHECK(good->name == "a \"quoted\" name");
}

TEST_CASE("errors of assignments are located at the assignment", "[unit][scene]") {
    const auto error = [](std::string_view text) {
        return first_error(parse(small_scene, {set(text)}));
    };
    CHECK(
        error("depth.tset=less") ==
        "--set depth.tset: there is no setting \"depth.tset\"; did you mean \"depth.test\"?"
    );
    CHECK(error("depth.test=lses").starts_with("--set depth.test: depth.test must be \"never\", "));
    CHECK(
        error("camera.eye=here").starts_with("--set camera.eye: eye of camera must be a list of 3")
    );
    CHECK(error("camera.eey=[0, 0, 1]").starts_with("--set camera.eey: camera has no key \"eey\""));
    CHECK(error("object.7.fit=true") == "--set object.7.fit: there is no 7 in object");
    CHECK(error("object.first.fit=true") == "--set object.first.fit: there is no first in object");
    CHECK(error("name.first=a") == "--set name.first: there is no first in name");
    CHECK(error("size=[0, 1\n0]").starts_with("--set size: size must be"));
    CHECK(error("size=1\nevil = 2").starts_with("--set size: size must be"));
    CHECK(error("name=\xff") == "--set name: the value is not UTF-8 text");
    CHECK(error("depth=1").starts_with("--set depth: depth is a group of settings"));
}

TEST_CASE("an assignment needs a key and an equals sign", "[unit][scene]") {
    CHECK(
        parse_assignment("size").diagnostics()[0].message == "\"size\" has no =: write key=value"
    );
    CHECK(
        parse_assignment(" = 3").diagnostics()[0].message == "\" = 3\" has no key: write key=value"
    );
    CHECK(parse_assignment("a = b = c")->value == "b = c");
}

TEST_CASE("everything wrong with a scene is reported, in the order of the file", "[unit][scene]") {
    const Result<Scene> scene = parse(R"([[object]]
vertices = [[0, 0]]
polygons = [[0, 1, 2]]
material = "none"

[camera]
eey = [0, 0, 0]

[settings]
cull = "both"
)");
    REQUIRE_FALSE(scene);
    std::vector<int> lines;
    for (const Diagnostic& diagnostic : scene.diagnostics()) {
        CHECK(diagnostic.file == "test.toml");
        lines.push_back(diagnostic.line);
    }
    CHECK(lines == std::vector<int>{2, 3, 3, 4, 7, 10});
}

TEST_CASE("a flood of errors ends in a remark", "[unit][scene]") {
    std::string text = "[[object]]\npolygons = []\nvertices = [";
    for (int i = 0; i < 5000; ++i) {
        text += "[0], ";
    }
    const Result<Scene> scene = parse(text + "]\n");
    REQUIRE_FALSE(scene);
    CHECK(scene.diagnostics().size() == 101);
}

TEST_CASE("instances of one mesh file share the mesh", "[unit][scene]") {
    const std::filesystem::path file = test::source_dir() / "tests/core/scene/test.toml";
    const Result<Scene> scene = parse_scene(
        "[[object]]\nmesh = \"meshes/square.off\"\n[[object]]\nmesh = "
        "\"meshes/../meshes/square.off\"\n"
        "[[object]]\nmesh = \"meshes/square.off\"\nfit = true\n",
        file
    );
    REQUIRE(first_error(scene) == "no error");
    CHECK(scene->objects[0].mesh == scene->objects[1].mesh);
    CHECK(scene->objects[0].mesh != scene->objects[2].mesh);
    CHECK(scene->files.size() == 1);
}

TEST_CASE("a bare mesh is a scene: fitted, lit, and open to assignments", "[unit][scene]") {
    const std::filesystem::path file = test::source_dir() / "tests/core/scene/meshes/square.off";
    const std::vector<Assignment> assignments{set("size=[20, 10]"), set("shading=flat")};
    const Result<Scene> scene = load_scene(file, assignments);
    REQUIRE(first_error(scene) == "no error");
    CHECK(scene->name == "square.off");
    CHECK(scene->objects.at(0).name == "square");
    CHECK(scene->settings.width == 20);
    CHECK(scene->settings.shading == Shading::flat);
    CHECK(scene->lights.size() == 2);
    float farthest = 0.0F;
    for (const glm::vec4& p : scene->objects[0].mesh->positions) {
        farthest = std::max(farthest, std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z));
    }
    CHECK(farthest == Approx(1.0F));
}

TEST_CASE("a scene around a mesh made by code is the scene of the bare file", "[unit][scene]") {
    Result<Mesh> mesh = make_shape("cube", {});
    const Scene scene = scene_of_mesh(std::move(*mesh));
    CHECK(scene.objects.at(0).material == 0);
    CHECK(scene.settings.shading == Shading::phong);
    CHECK(scene.objects[0].mesh->positions[0].x == Approx(-0.57735F));
}

TEST_CASE("missing files and folders are no scenes", "[unit][scene]") {
    CHECK(first_error(load_scene("nowhere.toml")) == "nowhere.toml: there is no such file");
    CHECK(first_error(load_scene(test::source_dir())).ends_with("there is no such file"));
    CHECK(first_error(load_scene("nowhere.obj")).find("there is no file") != std::string::npos);
}

TEST_CASE("every example scene opens", "[unit][scene]") {
    std::size_t count = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator{test::source_dir() / "lessons/scenes"}) {
        if (entry.path().extension() == ".toml") {
            INFO(entry.path());
            CHECK(first_error(load_scene(entry.path())) == "no error");
            ++count;
        }
    }
    CHECK(count >= 5);
}
