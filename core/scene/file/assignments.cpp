// `--set path=value` edits the parsed file, so that every check of the file holds for assignments,
// too.
#include "core/scene/file/scene_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace hs::scene {

Result<Assignment> parse_assignment(std::string_view text) {
    const std::size_t equals = text.find('=');
    const auto complaint = [&](std::string_view missing) {
        return Diagnostic{
            "--set", 0, 0, fmt::format("\"{}\" has no {}: write key=value", text, missing)};
    };
    if (equals == std::string_view::npos) {
        return complaint("=");
    }
    const auto trim = [](std::string_view part) {
        const std::size_t first = part.find_first_not_of(" \t");
        const std::size_t last = part.find_last_not_of(" \t");
        return first == std::string_view::npos ? ""
                                               : std::string{part.substr(first, last - first + 1)};
    };
    Assignment assignment{trim(text.substr(0, equals)), trim(text.substr(equals + 1))};
    if (assignment.path.empty()) {
        return complaint("key");
    }
    return assignment;
}

namespace file {

namespace {

constexpr std::string_view scene_words[] = {
    "name", "settings", "camera", "object", "material", "light"};

using Path = std::vector<std::string>;

/// "depth.test" means "settings.depth.test".
Path split_path(const std::string& text) {
    Path path;
    std::size_t start = 0;
    for (std::size_t dot = text.find('.'); dot != std::string::npos; dot = text.find('.', start)) {
        path.push_back(text.substr(start, dot - start));
        start = dot + 1;
    }
    path.push_back(text.substr(start));
    if (std::ranges::find(scene_words, path[0]) == std::end(scene_words)) {
        path.insert(path.begin(), "settings");
    }
    return path;
}

std::string toml_string(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            result += '\\';
        }
        result += code < 0x20 || code == 0x7F ? fmt::format("\\u{:04x}", code) : std::string(1, c);
    }
    return result + '"';
}

/// A table whose only entry is the value, or nothing when the text is no TOML value.
std::optional<toml::table> parse_value(const std::string& text, const std::string& origin) {
    try {
        toml::table table = toml::parse("value = " + text, origin);
        // A line break in the text could smuggle in further keys.
        return table.size() == 1 && table.contains("value") ? std::optional{std::move(table)}
                                                            : std::nullopt;
    } catch (const toml::parse_error&) {
        return std::nullopt; // not TOML: the caller takes it as a bare string
    }
}

std::optional<std::size_t> parse_index(const std::string& text) {
    std::size_t index = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, index);
    return error == std::errc{} && rest == end ? std::optional{index} : std::nullopt;
}

/// One segment down; missing tables are made on the way, but no key of a table is a number.
toml::node* descend(toml::node& node, const std::string& segment) {
    if (toml::table* table = node.as_table()) {
        if (!table->contains(segment) && !parse_index(segment)) {
            table->insert(segment, toml::table{});
        }
        return table->get(segment);
    }
    toml::array* list = node.as_array();
    const std::optional<std::size_t> index = parse_index(segment);
    return list != nullptr && index && *index < list->size() ? list->get(*index) : nullptr;
}

std::string join(const Path& path, std::size_t count) {
    return fmt::format(
        "{}", fmt::join(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(count), ".")
    );
}

/// What is wrong with the path, if anything.
std::optional<std::string> assign_node(toml::table& root, const Path& path, toml::node& value) {
    toml::node* place = &root;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        place = descend(*place, path[i]);
        if (place == nullptr) {
            return fmt::format("there is no {} in {}", path[i], join(path, i));
        }
    }
    const std::string& last = path.back();
    const std::optional<std::size_t> index = parse_index(last);
    if (toml::table* table = place->as_table(); table != nullptr && !index) {
        value.visit([&](auto& typed) { table->insert_or_assign(last, std::move(typed)); });
        return std::nullopt;
    }
    toml::array* list = place->as_array();
    if (list == nullptr || !index || *index >= list->size()) {
        return fmt::format("there is no {} in {}", last, join(path, path.size() - 1));
    }
    const auto position = list->cbegin() + static_cast<std::ptrdiff_t>(*index);
    value.visit([&](auto& typed) { list->replace(position, std::move(typed)); });
    return std::nullopt;
}

} // namespace

void apply_assignments(
    toml::table& root, std::span<const Assignment> assignments, Complaints& complaints
) {
    for (const Assignment& assignment : assignments) {
        const std::string origin = "--set " + assignment.path;
        std::optional<toml::table> parsed = parse_value(assignment.value, origin);
        if (!parsed) {
            parsed = parse_value(toml_string(assignment.value), origin);
        }
        const std::optional<std::string> complaint =
            parsed ? assign_node(root, split_path(assignment.path), *parsed->get("value"))
                   : std::optional<std::string>{"the value is not UTF-8 text"};
        if (complaint) {
            complaints.add(Diagnostics{{origin, 0, 0, *complaint}});
        }
    }
}

} // namespace file

} // namespace hs::scene
