#include "core/scene/scene_file.hpp"

#include "core/scene/file/scene_reader.hpp"
#include "core/scene/mesh_file.hpp"
#include "core/scene/triangulate.hpp"

#include <fmt/format.h>

#include <fstream>
#include <functional>
#include <sstream>

namespace hs::scene {

namespace {

using file::Complaints;
using file::SceneReader;
using file::TableReader;

constexpr std::uintmax_t largest_scene_file = 64U << 20U;

/// What surrounds a bare mesh: a headlight over the beholder's shoulder and a material that shows
/// form.
constexpr std::string_view bare_mesh_scene = R"(
[settings]
size = [512, 512]
background = [0.1, 0.1, 0.12, 1.0]
shading = "phong"

[camera]
eye = [0, 0, 3]

[[material]]
name = "default"
diffuse = [0.8, 0.8, 0.8]
specular = [0.2, 0.2, 0.2]

[[light]]
kind = "directional"
to_light = [1, 1, 2]

[[light]]
kind = "ambient"
color = [0.15, 0.15, 0.15]
)";

using ReadEntry = std::function<void(SceneReader&, const toml::table&, std::size_t)>;

/// [[object]], [[material]], [[light]].
void read_entries(
    SceneReader& reader, TableReader& root, std::string_view key, const ReadEntry& read
) {
    const std::string expected = fmt::format("written as [[{}]], with two brackets", key);
    const toml::array* entries = root.read_array(key, expected);
    if (entries == nullptr) {
        return;
    }
    std::size_t number = 0;
    for (const toml::node& entry : *entries) {
        if (const toml::table* table = entry.as_table()) {
            read(reader, *table, number);
        } else {
            reader.complaints.add(entry, fmt::format("{} must be a table", key));
        }
        ++number;
    }
}

void read_scene(SceneReader& reader, const toml::table& toml) {
    TableReader root{reader.complaints, toml, "the scene"};
    root.read("name", reader.scene.name);
    if (const toml::table* settings = root.read_table("settings")) {
        file::read_settings(reader, *settings);
    }
    if (const toml::table* camera = root.read_table("camera")) {
        file::read_camera(reader, *camera);
    }
    read_entries(reader, root, "material", file::read_material);
    read_entries(reader, root, "light", file::read_light);
    read_entries(reader, root, "object", file::read_object);
    root.finish();
}

Result<Scene> build_scene(
    toml::table root, const std::filesystem::path& path, std::span<const Assignment> assignments
) {
    Complaints complaints{path.string()};
    file::apply_assignments(root, assignments, complaints);
    Scene scene;
    scene.file = path.string();
    SceneReader reader{scene, complaints, path.parent_path()};
    read_scene(reader, root);
    if (!complaints.empty()) {
        return complaints.sorted();
    }
    return scene;
}

Result<toml::table> parse_toml(std::string_view text, const std::string& file) {
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        const toml::source_position at = error.source().begin;
        return Diagnostic{
            file,
            static_cast<int>(at.line),
            static_cast<int>(at.column),
            std::string{error.description()}};
    }
}

Result<std::string> read_text(const std::filesystem::path& path) {
    const auto complaint = [&](std::string message) {
        return Diagnostic{path.string(), 0, 0, std::move(message)};
    };
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        return complaint("there is no such file");
    }
    if (std::filesystem::file_size(path, error) > largest_scene_file) {
        return complaint("a scene file can have at most 64 MB: put large meshes into mesh files");
    }
    std::ifstream stream{path, std::ios::binary};
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) {
        return complaint("the file cannot be read");
    }
    return text.str();
}

Result<Scene>
load_bare_mesh(const std::filesystem::path& path, std::span<const Assignment> assignments) {
    Result<toml::table> root = parse_toml(bare_mesh_scene, path.string());
    root->insert("name", path.filename().string());
    toml::table object{
        {"name", path.stem().string()},
        {"mesh", path.filename().string()},
        {"fit", true},
        {"material", "default"}};
    root->insert("object", toml::array{std::move(object)});
    return build_scene(std::move(*root), path, assignments);
}

} // namespace

Result<Scene>
load_scene(const std::filesystem::path& path, std::span<const Assignment> assignments) {
    if (is_mesh_file(path)) {
        return load_bare_mesh(path, assignments);
    }
    Result<std::string> text = read_text(path);
    if (!text) {
        return text.diagnostics();
    }
    return parse_scene(*text, path, assignments);
}

Result<Scene> parse_scene(
    std::string_view text,
    const std::filesystem::path& file,
    std::span<const Assignment> assignments
) {
    Result<toml::table> root = parse_toml(text, file.string());
    if (!root) {
        return root.diagnostics();
    }
    return build_scene(std::move(*root), file, assignments);
}

Scene scene_of_mesh(Mesh mesh) {
    Result<Scene> scene = parse_scene(bare_mesh_scene, "");
    HS_CHECK(scene, "the scene around a bare mesh is well-formed");
    fit_to_unit_sphere(mesh);
    scene->name = mesh.name;
    scene->objects.push_back({mesh.name, std::make_shared<const Mesh>(std::move(mesh)), 0, {}, {}});
    return std::move(*scene);
}

} // namespace hs::scene
