// Every file of tests/must_fail is refused with the sentence written next to it: in the first line
// of a scene
// (`# expect: line:column: sentence`), in meshes/expected.txt for meshes (`file:line: sentence`).
#include "core/scene/mesh_file.hpp"
#include "core/scene/scene_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <filesystem>
#include <fstream>
#include <set>

using namespace hs;

namespace {

std::filesystem::path folder() {
    return test::source_dir() / "tests/must_fail";
}

std::string first_line(const std::filesystem::path& path) {
    std::ifstream stream{path};
    std::string line;
    std::getline(stream, line);
    return line;
}

/// Messages name files by their full path, expectations relative to this folder.
std::string relative(std::string message) {
    const std::string prefix = folder().string() + '/';
    for (std::size_t at = message.find(prefix); at != std::string::npos;
         at = message.find(prefix)) {
        message.erase(at, prefix.size());
    }
    return message;
}

} // namespace

TEST_CASE("every bad scene is refused with its located sentence", "[unit][scene][must_fail]") {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator{folder() / "scenes"}) {
        INFO(entry.path());
        const std::string expected = first_line(entry.path());
        REQUIRE(expected.starts_with("# expect: "));
        const auto scene = scene::load_scene(entry.path());
        REQUIRE_FALSE(scene);
        std::string message = relative(scene.diagnostics().front().to_string());
        const std::string own_name = "scenes/" + entry.path().filename().string() + ':';
        if (message.starts_with(own_name)) {
            message.erase(0, own_name.size());
        }
        CHECK("# expect: " + message == expected);
        ++count;
    }
    CHECK(count >= 60);
}

TEST_CASE("every bad mesh is refused with its located sentence", "[unit][scene][must_fail]") {
    std::set<std::string> expected;
    std::ifstream stream{folder() / "meshes/expected.txt"};
    for (std::string line; std::getline(stream, line);) {
        expected.insert("meshes/" + line);
    }
    CHECK(expected.size() >= 50);
    for (const auto& entry : std::filesystem::directory_iterator{folder() / "meshes"}) {
        if (!scene::is_mesh_file(entry.path())) {
            continue;
        }
        INFO(entry.path());
        const auto mesh = scene::load_mesh(entry.path());
        REQUIRE_FALSE(mesh);
        const std::string message = relative(mesh.diagnostics().front().to_string());
        INFO(message);
        CHECK(expected.erase(message) == 1);
    }
    CHECK(expected.empty()); // nothing is expected of files that are not there
}
