// Values of settings as text and as numbers: what the rows of the table of settings are made of.
#pragma once

#include "core/scene/settings.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hs::scene {

inline constexpr int max_size = 8192; ///< pixels along a side of an image

/// As TOML.
std::string print_value(const SettingValue& value);

/// "size must be [width, height], not 8"
std::string must_be(std::string_view key, std::string_view expected, const SettingValue& value);

/// A whole or floating number that a float can hold.
std::optional<float> to_float(const SettingValue& value);
/// A whole number within limits.
std::optional<int> to_int(const SettingValue& value, int lowest, int highest);

/// The entries of a list; empty for anything else.
std::span<const SettingValue> entries(const SettingValue& value);

std::optional<glm::vec4> to_vec4(const SettingValue& value);
SettingValue from_vec4(const glm::vec4& v);

/// [x, y, width, height] in pixels.
std::optional<PixelRect> to_rect(const SettingValue& value);
SettingValue from_rect(const PixelRect& rect);

} // namespace hs::scene
