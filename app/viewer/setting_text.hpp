// Settings as text in fields: "[64, 64]", "0.5", "false".
#pragma once

#include "core/scene/settings.hpp"

#include <optional>
#include <string_view>

namespace hs::viewer {

/// Numbers, true, false, and lists of them; nothing for any other text.
std::optional<scene::SettingValue> parse_setting_text(std::string_view text);

/// Why a setting has no effect at present, in one sentence; empty when it has.
std::string_view why_ignored(const scene::Settings& settings, std::string_view key);

} // namespace hs::viewer
