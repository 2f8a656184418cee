#include "core/scene/setting_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace hs::scene {
namespace {

/// The shortest TOML float that reads back as the same value.
std::string print_number(double number) {
    const auto as_float = static_cast<float>(number);
    const bool is_float = static_cast<double>(as_float) == number;
    std::string text = is_float ? fmt::format("{}", as_float) : fmt::format("{}", number);
    if (text.find_first_of(".en") == std::string::npos) {
        text += ".0";
    }
    return text;
}

} // namespace

std::string print_value(const SettingValue& value) {
    if (const bool* truth = std::get_if<bool>(&value.value)) {
        return *truth ? "true" : "false";
    }
    if (const std::int64_t* whole = std::get_if<std::int64_t>(&value.value)) {
        return std::to_string(*whole);
    }
    if (const double* number = std::get_if<double>(&value.value)) {
        return print_number(*number);
    }
    if (const std::string* text = std::get_if<std::string>(&value.value)) {
        return '"' + *text + '"';
    }
    std::string list;
    for (const SettingValue& entry : std::get<SettingValue::List>(value.value)) {
        list += (list.empty() ? "" : ", ") + print_value(entry);
    }
    return '[' + list + ']';
}

std::string must_be(std::string_view key, std::string_view expected, const SettingValue& value) {
    constexpr std::size_t longest_quote = 60;
    std::string got = print_value(value);
    if (got.size() > longest_quote) {
        got = got.substr(0, longest_quote) + "…";
    }
    return fmt::format("{} must be {}, not {}", key, expected, got);
}

std::optional<float> to_float(const SettingValue& value) {
    double number = 0.0;
    if (const std::int64_t* whole = std::get_if<std::int64_t>(&value.value)) {
        number = static_cast<double>(*whole);
    } else if (const double* real = std::get_if<double>(&value.value)) {
        number = *real;
    } else {
        return std::nullopt;
    }
    if (!(std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max()))) {
        return std::nullopt; // infinite, too large, or NaN
    }
    return static_cast<float>(number);
}

std::optional<int> to_int(const SettingValue& value, int lowest, int highest) {
    const std::int64_t* whole = std::get_if<std::int64_t>(&value.value);
    if (whole == nullptr || *whole < lowest || *whole > highest) {
        return std::nullopt;
    }
    return static_cast<int>(*whole);
}

std::span<const SettingValue> entries(const SettingValue& value) {
    const SettingValue::List* list = std::get_if<SettingValue::List>(&value.value);
    return list == nullptr ? std::span<const SettingValue>{} : std::span{*list};
}

std::optional<glm::vec4> to_vec4(const SettingValue& value) {
    const std::span<const SettingValue> list = entries(value);
    if (list.size() != 4) {
        return std::nullopt;
    }
    glm::vec4 result{0.0F};
    for (int i = 0; i < 4; ++i) {
        const std::optional<float> entry = to_float(list[static_cast<std::size_t>(i)]);
        if (!entry) {
            return std::nullopt;
        }
        result[i] = *entry;
    }
    return result;
}

SettingValue from_vec4(const glm::vec4& v) {
    SettingValue::List list;
    for (int i = 0; i < 4; ++i) {
        list.emplace_back().value = static_cast<double>(v[i]);
    }
    return {list};
}

std::optional<PixelRect> to_rect(const SettingValue& value) {
    const std::span<const SettingValue> list = entries(value);
    if (list.size() != 4) {
        return std::nullopt;
    }
    const std::optional<int> x = to_int(list[0], -max_size, max_size);
    const std::optional<int> y = to_int(list[1], -max_size, max_size);
    const std::optional<int> width = to_int(list[2], 0, max_size);
    const std::optional<int> height = to_int(list[3], 0, max_size);
    if (!x || !y || !width || !height) {
        return std::nullopt;
    }
    return PixelRect{*x, *y, *x + *width, *y + *height};
}

SettingValue from_rect(const PixelRect& rect) {
    return {SettingValue::List{
        {std::int64_t{rect.x0}},
        {std::int64_t{rect.y0}},
        {std::int64_t{rect.width()}},
        {std::int64_t{rect.height()}},
    }};
}

} // namespace hs::scene
