#include "app/viewer/setting_text.hpp"

#include <charconv>

namespace hs::viewer {
namespace {

using scene::SettingValue;

/// Reads one value after another from the front of a text.
class Reader {
public:
    explicit Reader(std::string_view text) : rest_(text) {}

    std::optional<SettingValue> value() {
        skip_spaces();
        if (take("[")) {
            return list();
        }
        if (take("true")) {
            return SettingValue{true};
        }
        if (take("false")) {
            return SettingValue{false};
        }
        return number();
    }
    bool at_end() {
        skip_spaces();
        return rest_.empty();
    }

private:
    std::optional<SettingValue> list() {
        SettingValue::List entries;
        for (skip_spaces(); !take("]"); skip_spaces()) {
            const std::optional<SettingValue> entry = value();
            if (!entry) {
                return std::nullopt;
            }
            entries.push_back(*entry);
            skip_spaces();
            if (!take(",") && !rest_.starts_with(']')) {
                return std::nullopt;
            }
        }
        return SettingValue{entries};
    }
    std::optional<SettingValue> number() {
        const char* const end = rest_.data() + rest_.size();
        std::int64_t whole = 0;
        double real = 0.0;
        const auto as_whole = std::from_chars(rest_.data(), end, whole);
        const auto as_real = std::from_chars(rest_.data(), end, real);
        if (as_real.ec != std::errc{}) {
            return std::nullopt;
        }
        rest_.remove_prefix(static_cast<std::size_t>(as_real.ptr - rest_.data()));
        const bool is_whole = as_whole.ec == std::errc{} && as_whole.ptr == as_real.ptr;
        return is_whole ? SettingValue{whole} : SettingValue{real};
    }
    bool take(std::string_view word) {
        if (!rest_.starts_with(word)) {
            return false;
        }
        rest_.remove_prefix(word.size());
        return true;
    }
    void skip_spaces() {
        while (rest_.starts_with(' ')) {
            rest_.remove_prefix(1);
        }
    }

    std::string_view rest_;
};

} // namespace

std::optional<SettingValue> parse_setting_text(std::string_view text) {
    Reader reader{text};
    std::optional<SettingValue> value = reader.value();
    return reader.at_end() ? value : std::nullopt;
}

std::vector<std::string> values_beside(const scene::Settings& settings, std::string_view key) {
    const scene::SettingInfo& info = *scene::find_setting(key);
    std::vector<std::string> values;
    if (info.type == scene::SettingType::boolean) {
        values = {"true", "false"};
    }
    values.insert(values.end(), info.choices.begin(), info.choices.end());
    const std::string present = scene::print_setting(settings, key);
    std::erase_if(values, [&present](const std::string& value) {
        return value == present || '"' + value + '"' == present;
    });
    return values;
}

std::string_view why_ignored(const scene::Settings& settings, std::string_view key) {
    const bool z_buffer = settings.visibility == scene::Visibility::z_buffer;
    if (!z_buffer && key.starts_with("depth.") && key != "depth.convention") {
        return "Only the z-buffer compares and stores depths.";
    }
    if (settings.sweeps() && (key == "traversal" || key == "tile_size")) {
        return "Rows of the image show the nearest of all triangles: none is traversed.";
    }
    if (!settings.clip_enabled && key == "clip.planes") {
        return "Clipping is switched off (clip.enabled).";
    }
    if (settings.cull == scene::CullFace::none && key == "front_face") {
        return settings.shading == scene::Shading::flat
                   ? ""
                   : "No side is culled, so nothing depends on which one is the front.";
    }
    return "";
}

} // namespace hs::viewer
