#include "core/scene/file/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace hs::scene::file {

namespace {

constexpr std::size_t most_complaints = 100;

std::string excerpt(const toml::node& node);

std::string excerpt_of_list(const toml::array& list) {
    constexpr std::size_t longest = 60;
    std::string text;
    for (const toml::node& entry : list) {
        text += (text.empty() ? "" : ", ") + excerpt(entry);
        if (text.size() > longest) {
            return '[' + text + ", …]";
        }
    }
    return '[' + text + ']';
}

std::string excerpt(const toml::node& node) {
    if (const auto* text = node.as_string()) {
        constexpr std::size_t longest = 40;
        const std::string& value = text->get();
        return value.size() <= longest ? '"' + value + '"' : '"' + value.substr(0, longest) + "…\"";
    }
    if (const auto* whole = node.as_integer()) {
        return std::to_string(whole->get());
    }
    if (const auto* number = node.as_floating_point()) {
        return fmt::format("{}", number->get());
    }
    if (const auto* truth = node.as_boolean()) {
        return truth->get() ? "true" : "false";
    }
    if (const toml::array* list = node.as_array()) {
        return excerpt_of_list(*list);
    }
    return node.is_table() ? "a table" : "a date or time";
}

} // namespace

void Complaints::add(const toml::source_region& at, std::string message) {
    if (list_.size() == most_complaints) {
        list_.push_back({file_, 0, 0, "there are more errors than are listed here"});
    }
    if (list_.size() > most_complaints) {
        return;
    }
    if (at.path && *at.path != file_) {
        list_.push_back({*at.path, 0, 0, std::move(message)});
        return;
    }
    const auto line = static_cast<int>(at.begin.line);
    const auto column = static_cast<int>(at.begin.column);
    list_.push_back({file_, line, column, std::move(message)});
}

void Complaints::add_at_key(const toml::key& key, const toml::node& value, std::string message) {
    const toml::source_region& at_key = key.source();
    const toml::source_region& at_value = value.source();
    const bool same_file = at_key.path && at_value.path && *at_key.path == *at_value.path;
    add(same_file ? at_key : at_value, std::move(message));
}

void Complaints::add(Diagnostics others) {
    list_.insert(list_.end(), others.begin(), others.end());
}

Diagnostics Complaints::sorted() const {
    Diagnostics sorted = list_;
    const auto place = [&](const Diagnostic& d) {
        if (d.file != file_) {
            return std::tuple{d.file.starts_with("--set") ? 0 : 2, 0, 0};
        }
        // "The whole" (line 0) comes after what is located.
        return std::tuple{1, d.line == 0 ? std::numeric_limits<int>::max() : d.line, d.column};
    };
    std::ranges::stable_sort(sorted, std::less<>{}, place);
    return sorted;
}

std::optional<float> read_float(const toml::node& node) {
    double number = 0.0;
    if (const auto* whole = node.as_integer()) {
        number = static_cast<double>(whole->get());
    } else if (const auto* real = node.as_floating_point()) {
        number = real->get();
    } else {
        return std::nullopt;
    }
    if (!(std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max()))) {
        return std::nullopt; // infinite, too large, or NaN
    }
    return static_cast<float>(number);
}

std::optional<std::vector<float>>
read_floats(const toml::node& node, std::size_t lowest, std::size_t highest) {
    const toml::array* list = node.as_array();
    if (list == nullptr || list->size() < lowest || list->size() > highest) {
        return std::nullopt;
    }
    std::vector<float> numbers;
    for (const toml::node& entry : *list) {
        const std::optional<float> number = read_float(entry);
        if (!number) {
            return std::nullopt;
        }
        numbers.push_back(*number);
    }
    return numbers;
}

const toml::node* TableReader::find(std::string_view key) {
    known_.push_back(key);
    return table_.get(key);
}

void TableReader::must_be(std::string_view key, std::string_view expected) {
    const toml::node* node = table_.get(key);
    complaints_.add(
        *node, fmt::format("{} of {} must be {}, not {}", key, name_, expected, excerpt(*node))
    );
}

void TableReader::complain(std::string message) {
    complaints_.add(table_, std::move(message));
}

bool TableReader::read(std::string_view key, bool& target) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return false;
    }
    if (const auto* truth = node->as_boolean()) {
        target = truth->get();
        return true;
    }
    must_be(key, "true or false");
    return false;
}

bool TableReader::read(std::string_view key, float& target) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return false;
    }
    if (const std::optional<float> number = read_float(*node)) {
        target = *number;
        return true;
    }
    must_be(key, "a finite number");
    return false;
}

bool TableReader::read(std::string_view key, int& target, int lowest, int highest) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return false;
    }
    const auto* whole = node->as_integer();
    if (whole != nullptr && whole->get() >= lowest && whole->get() <= highest) {
        target = static_cast<int>(whole->get());
        return true;
    }
    must_be(key, fmt::format("a whole number from {} to {}", lowest, highest));
    return false;
}

bool TableReader::read(std::string_view key, std::string& target) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return false;
    }
    if (const auto* text = node->as_string()) {
        target = text->get();
        return true;
    }
    must_be(key, "a text in quotes");
    return false;
}

bool TableReader::read(std::string_view key, glm::vec3& target) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return false;
    }
    if (const auto numbers = read_floats(*node, 3, 3)) {
        target = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
        return true;
    }
    must_be(key, "a list of 3 finite numbers");
    return false;
}

std::optional<std::string>
TableReader::read_one_of(std::string_view key, std::span<const std::string_view> choices) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    const auto* text = node->as_string();
    if (text != nullptr && std::ranges::find(choices, text->get()) != choices.end()) {
        return text->get();
    }
    must_be(key, list_of_choices(choices));
    return std::nullopt;
}

const toml::table* TableReader::read_table(std::string_view key) {
    const toml::node* node = find(key);
    if (node != nullptr && !node->is_table()) {
        must_be(key, "a table");
    }
    return node == nullptr ? nullptr : node->as_table();
}

const toml::array* TableReader::read_array(std::string_view key, std::string_view expected) {
    const toml::node* node = find(key);
    if (node != nullptr && !node->is_array()) {
        must_be(key, expected);
    }
    return node == nullptr ? nullptr : node->as_array();
}

void TableReader::finish() {
    for (const auto& [key, node] : table_) {
        if (std::ranges::find(known_, key.str()) != known_.end()) {
            continue;
        }
        complaints_.add_at_key(
            key,
            node,
            fmt::format("{} has no key \"{}\"{}", name_, key.str(), did_you_mean(key.str(), known_))
        );
    }
}

} // namespace hs::scene::file
