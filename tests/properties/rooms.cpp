// Arrows point one way: reads the #include lines of the sources.
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

using namespace hs;

namespace {

struct Include {
    std::string file; ///< "core/raster/traverse.hpp"
    int line = 0;
    std::string header; ///< "core/base/check.hpp" or "fmt/format.h"
    bool quoted = false;
};

/// The header of an include directive, or nothing.
std::string header_in(const std::string& line, char open, char close) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line.compare(hash, 8, "#include") != 0) {
        return {};
    }
    const std::size_t begin = line.find(open, hash + 8);
    const std::size_t end = line.find(close, begin + 1);
    return begin == std::string::npos || end == std::string::npos
               ? std::string{}
               : line.substr(begin + 1, end - begin - 1);
}

std::vector<Include> includes_below(const std::string& folder) {
    const std::filesystem::path top = test::source_dir();
    std::vector<Include> result;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(top / folder)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".cpp" && extension != ".hpp") {
            continue;
        }
        std::ifstream file(entry.path());
        const std::string name = std::filesystem::relative(entry.path(), top).generic_string();
        int number = 0;
        for (std::string line; std::getline(file, line);) {
            ++number;
            if (const std::string header = header_in(line, '"', '"'); !header.empty()) {
                result.push_back({name, number, header, true});
            } else if (const std::string system = header_in(line, '<', '>'); !system.empty()) {
                result.push_back({name, number, system, false});
            }
        }
    }
    return result;
}

/// "core/raster" of "core/raster/traverse.hpp".
std::string room_of(const std::string& path) {
    return path.substr(0, path.find('/', path.find('/') + 1));
}

std::string where(const Include& include) {
    return include.file + ":" + std::to_string(include.line) + " includes " + include.header;
}

using Rooms = std::set<std::string>;

/// What each room may include besides itself. Sibling rooms know nothing of each other.
std::map<std::string, Rooms> allowed_rooms() {
    const Rooms below{"core/base", "core/math", "core/scene"};
    Rooms siblings{below};
    siblings.insert(
        {"core/geometry",
         "core/raster",
         "core/shading",
         "core/fragment",
         "core/framebuffer",
         "core/visibility"}
    );
    Rooms with_pipeline{siblings};
    with_pipeline.insert("core/pipeline");
    Rooms with_trace{with_pipeline};
    with_trace.insert("core/trace");
    Rooms with_explain{with_trace};
    with_explain.insert("core/explain");
    Rooms with_export{with_explain};
    with_export.insert("core/export");
    return {
        {"core/base", {}},
        {"core/math", {"core/base"}},
        {"core/scene", {"core/base", "core/math"}},
        {"core/geometry", below},
        {"core/raster", below},
        {"core/shading", below},
        {"core/fragment", below},
        {"core/framebuffer", below},
        {"core/visibility", below},
        {"core/pipeline", siblings},
        {"core/trace", with_pipeline},
        {"core/explain", with_trace},
        {"core/export", with_explain},
        {"core/search", with_export},
    };
}

/// Libraries that only the files adapting them may include, and where those are.
const std::map<std::string_view, std::vector<std::string_view>> adapters{
    {"OpenMesh/", {"core/scene/mesh/", "core/scene/mesh_file.cpp"}},
    {"OpenImageIO/", {"core/scene/image_file.cpp", "core/export/"}},
    {"toml++/", {"core/scene/file/", "core/scene/scene_file.cpp", "app/lesson/"}},
    {"nlohmann/", {"core/export/", "app/command/", "app/bench/"}},
    {"zip.h", {"core/export/"}},
    {"lua.hpp", {"core/search/"}},
    {"md4c.h", {"app/lesson/"}},
    {"imgui", {"app/viewer/", "app/host/", "app/bench/"}}, // bench times the viewer
    {"backends/imgui", {"app/host/"}},
    {"GLFW/", {"app/host/"}},
    {"GL/", {"app/host/", "app/peer/"}},
    {"CLI/", {"app/command/", "app/main.cpp"}},
};

bool starts_with_one_of(const std::string& text, const std::vector<std::string_view>& beginnings) {
    return std::ranges::any_of(beginnings, [&](std::string_view beginning) {
        return text.starts_with(beginning);
    });
}

bool is_scene_data(const std::string& header) {
    static const std::set<std::string> data{
        "core/scene/camera.hpp",
        "core/scene/mesh.hpp",
        "core/scene/scene.hpp",
        "core/scene/settings.hpp",
        "core/scene/texture.hpp"};
    return data.contains(header);
}

} // namespace

TEST_CASE("rooms include only the rooms below them", "[property][rooms]") {
    const std::map<std::string, Rooms> allowed = allowed_rooms();
    const std::vector<Include> includes = includes_below("core");
    REQUIRE(includes.size() > 100);
    for (const Include& include : includes) {
        if (!include.quoted) {
            continue;
        }
        const std::string from = room_of(include.file);
        const std::string to = room_of(include.header);
        INFO(where(include));
        REQUIRE(allowed.contains(from));
        const bool downward = from == to || allowed.at(from).contains(to);
        CHECK(downward);
    }
}

TEST_CASE("rooms see the scene as data, not as files", "[property][rooms]") {
    for (const Include& include : includes_below("core")) {
        const std::string from = room_of(include.file);
        const bool stage = from != "core/scene" && from != "core/export";
        if (stage && room_of(include.header) == "core/scene") {
            INFO(where(include));
            CHECK(is_scene_data(include.header));
        }
    }
}

TEST_CASE("the lessons' loader needs nothing of the app", "[property][rooms]") {
    for (const Include& include : includes_below("app/lesson")) {
        if (include.quoted && include.header.find('/') != std::string::npos) {
            INFO(where(include));
            const bool below =
                include.header.starts_with("core/") || include.header.starts_with("app/lesson/");
            CHECK(below);
        }
    }
}

TEST_CASE("libraries are included only by the files that adapt them", "[property][rooms]") {
    std::vector<Include> includes = includes_below("core");
    const std::vector<Include> in_app = includes_below("app");
    includes.insert(includes.end(), in_app.begin(), in_app.end());
    for (const Include& include : includes) {
        for (const auto& [library, files] : adapters) {
            if (!include.quoted && include.header.starts_with(library)) {
                INFO(where(include));
                CHECK(starts_with_one_of(include.file, files));
            }
        }
    }
}

TEST_CASE("core knows no window, no OpenGL and no ImGui", "[property][rooms]") {
    const std::vector<std::string_view> known{
        "glm/",
        "fmt/",
        "OpenMesh/",
        "OpenImageIO/",
        "toml++/",
        "nlohmann/",
        "zip.h",
        "lua.hpp",
        "fcntl.h",
        "unistd.h"};
    for (const Include& include : includes_below("core")) {
        const bool of_a_library = include.header.find_first_of("/.") != std::string::npos;
        if (!include.quoted && of_a_library) {
            INFO(where(include));
            CHECK(starts_with_one_of(include.header, known));
        }
    }
}
