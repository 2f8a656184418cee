// Scene files: TOML in, Scene out. Only scene_file.cpp and the folder file/ know toml++.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/scene/scene.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace hs::scene {

/// `--set path=value`: the path of any entry of the scene ("camera.eye",
/// "object.0.transform.1.rotate.degrees"); without a known first word it means [settings]. The
/// value is TOML, else a bare string.
struct Assignment {
    std::string path;
    std::string value;
};

/// "depth.test=always" to an Assignment; the error names what is missing.
Result<Assignment> parse_assignment(std::string_view text);

/// Opens a scene file (.toml) or a bare mesh (.obj .off .ply .stl .om: fitted, lit, viewed by a
/// default camera). Errors: everything wrong with it, located by file, line and column.
Result<Scene>
load_scene(const std::filesystem::path& path, std::span<const Assignment> assignments = {});

/// The same from text; `file` names it in messages, relative paths resolve against its folder.
Result<Scene> parse_scene(
    std::string_view text,
    const std::filesystem::path& file,
    std::span<const Assignment> assignments = {}
);

/// A scene around a mesh: centered, scaled into the unit sphere, lit, viewed by a default camera.
Scene scene_of_mesh(Mesh mesh);

} // namespace hs::scene
