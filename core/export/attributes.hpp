// What a file says about where it comes from.
#pragma once

#include "core/trace/player.hpp"

#include <string>
#include <utility>
#include <vector>

namespace hs::exporting {

/// Names and texts: ("halfspace:step", "object 0 / triangle 12"). PNG and EXR carry them as text
/// attributes, NPZ as manifest.json.
using Attributes = std::vector<std::pair<std::string, std::string>>;

/// Program, scene and every setting.
[[nodiscard]] Attributes attributes_of(const scene::Scene& scene);

/// These, and the step: its path and its flat number.
[[nodiscard]] Attributes attributes_of(const trace::Player& player);

} // namespace hs::exporting
