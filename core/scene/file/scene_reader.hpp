// The parts of a scene file. Every function reads one table into the scene and complains about what
// is wrong with it.
#pragma once

#include "core/scene/file/table_reader.hpp"
#include "core/scene/scene.hpp"
#include "core/scene/scene_file.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <utility>

namespace hs::scene::file {

/// A scene while it is read.
struct SceneReader {
    Scene& scene;
    Complaints& complaints;
    std::filesystem::path folder; ///< relative paths start here
    /// What was loaded already, by path and whether it was fitted; null: it failed.
    std::map<std::pair<std::string, bool>, std::shared_ptr<const Mesh>> meshes{};
    std::map<std::string, std::shared_ptr<const Texture>> textures{};
};

/// Puts `--set` values into the parsed file, as if they had been written there.
void apply_assignments(
    toml::table& root, std::span<const Assignment> assignments, Complaints& complaints
);

void read_settings(SceneReader& reader, const toml::table& table);
/// An object's own settings: checked against the table of settings, kept as written.
void read_overrides(SceneReader& reader, const toml::table& table, Object& object);
void read_camera(SceneReader& reader, const toml::table& toml);
void read_material(SceneReader& reader, const toml::table& toml, std::size_t number);
void read_light(SceneReader& reader, const toml::table& toml, std::size_t number);
/// Materials come first: objects name them.
void read_object(SceneReader& reader, const toml::table& toml, std::size_t number);
/// `transform` and `material` of an object that is there already, in place of what it has.
void read_placement(SceneReader& reader, const toml::table& toml, Object& object);

/// `vertices`, `polygons`, `lines`, `points`, `colors`, `normals`, `uvs`; null with complaints when
/// something is wrong.
std::shared_ptr<const Mesh> read_inline_mesh(TableReader& object, bool fit);

/// The resolved path of a file named in the scene, noted in `Scene::files`; nothing, with a
/// complaint, when it is missing.
std::optional<std::filesystem::path>
find_file(SceneReader& reader, const toml::node& node, const std::string& name);

} // namespace hs::scene::file
