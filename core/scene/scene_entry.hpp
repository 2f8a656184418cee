// One entry of a scene in memory, by its path in the scene file: `camera.eye`,
// `object.0.transform`, `object.ball.transform.1.rotate.degrees`. Settings have a table of their
// own (settings.hpp).
#pragma once

#include "core/scene/scene.hpp"
#include "core/scene/scene_file.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace hs::scene {

/// Whether a path leads into the camera or an object, not to a setting.
[[nodiscard]] bool is_scene_entry(std::string_view path);

/// Changes what the path names. An object is meant by its number or its name; its mesh stays. What
/// is wrong, in one sentence without location; the scene is unspecified then.
/// Precondition: is_scene_entry(change.path).
[[nodiscard]] std::optional<std::string> change_entry(Scene& scene, const Assignment& change);

/// As TOML text; empty where there is nothing of that path.
[[nodiscard]] std::string print_entry(const Scene& scene, std::string_view path);

} // namespace hs::scene
