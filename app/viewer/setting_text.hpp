// Settings as text in fields: "[64, 64]", "0.5", "false".
#pragma once

#include "core/scene/settings.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hs::viewer {

/// Numbers, true, false, and lists of them; nothing for any other text.
std::optional<scene::SettingValue> parse_setting_text(std::string_view text);

/// The values of a setting that could stand beside the present one; none where it is no choice.
std::vector<std::string> values_beside(const scene::Settings& settings, std::string_view key);

/// Why a setting has no effect at present, in one sentence; empty when it has.
std::string_view why_ignored(const scene::Settings& settings, std::string_view key);

} // namespace hs::viewer
