#include "core/scene/file/scene_reader.hpp"
#include "core/scene/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace hs::scene::file {

namespace {

/// Empty for what no setting takes: tables, dates and times.
std::optional<SettingValue> to_value(const toml::node& node) {
    if (const auto* truth = node.as_boolean()) {
        return SettingValue{truth->get()};
    }
    if (const auto* whole = node.as_integer()) {
        return SettingValue{whole->get()};
    }
    if (const auto* number = node.as_floating_point()) {
        return SettingValue{number->get()};
    }
    if (const auto* text = node.as_string()) {
        return SettingValue{text->get()};
    }
    const toml::array* list = node.as_array();
    if (list == nullptr) {
        return std::nullopt;
    }
    SettingValue::List values;
    for (const toml::node& entry : *list) {
        std::optional<SettingValue> value = to_value(entry);
        if (!value) {
            return std::nullopt;
        }
        values.push_back(std::move(*value));
    }
    return SettingValue{std::move(values)};
}

bool is_group(std::string_view path) {
    const std::string prefix = std::string{path} + '.';
    return std::ranges::any_of(setting_infos(), [&](const SettingInfo& info) {
        return info.key.starts_with(prefix);
    });
}

/// What to do with one setting; returns a complaint.
using Visit =
    std::function<std::optional<std::string>(const std::string& key, const SettingValue& value)>;

std::optional<std::string>
visit_setting(const std::string& key, const toml::node& node, const Visit& visit) {
    if (is_group(key)) {
        return fmt::format("{} is a group of settings: write {}.… = …", key, key);
    }
    const std::optional<SettingValue> value = to_value(node);
    if (!value) {
        return fmt::format("{} cannot be a table, a date or a time", key);
    }
    return visit(key, *value);
}

/// Dots in keys make nested tables; this puts the dots back.
void visit_settings(
    Complaints& complaints, const toml::table& table, const std::string& prefix, const Visit& visit
) {
    for (const auto& [key, node] : table) {
        const std::string path = prefix + std::string{key.str()};
        if (node.is_table() && is_group(path)) {
            visit_settings(complaints, *node.as_table(), path + '.', visit);
            continue;
        }
        const std::optional<std::string> complaint = visit_setting(path, node, visit);
        if (complaint && find_setting(path) == nullptr) {
            complaints.add_at_key(key, node, *complaint);
        } else if (complaint) {
            complaints.add(node, *complaint);
        }
    }
}

} // namespace

void read_settings(SceneReader& reader, const toml::table& table) {
    Settings& settings = reader.scene.settings;
    visit_settings(
        reader.complaints,
        table,
        "",
        [&](const std::string& key, const SettingValue& value) {
            return assign(settings, key, value);
        }
    );
    if (const auto complaint = check_combination(settings)) {
        // The complaint's first word is the key it is about
        const toml::node* culprit = table.get(complaint->substr(0, complaint->find(' ')));
        reader.complaints.add(culprit != nullptr ? *culprit : table, *complaint);
    }
}

void read_overrides(SceneReader& reader, const toml::table& table, Object& object) {
    Settings scratch = reader.scene.settings;
    visit_settings(
        reader.complaints,
        table,
        "",
        [&](const std::string& key, const SettingValue& value) {
            std::optional<std::string> complaint = assign(scratch, key, value);
            const SettingInfo* info = find_setting(key);
            if (!complaint && !info->per_object) {
                complaint = fmt::format("{} belongs to the whole frame: set it in [settings]", key);
            }
            if (!complaint) {
                object.overrides.emplace_back(key, value);
            }
            return complaint;
        }
    );
}

} // namespace hs::scene::file
