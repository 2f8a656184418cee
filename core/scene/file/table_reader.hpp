// Typed entries out of TOML tables, with a located complaint for everything that does not fit. Only
// the files of this folder and scene_file.cpp include toml++.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/base/named.hpp"
#include "core/base/spelling.hpp"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <toml++/toml.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hs::scene::file {

/// Everything wrong with one file, in the order found, up to a number nobody reads on from.
class Complaints {
public:
    explicit Complaints(std::string file) : file_(std::move(file)) {}

    /// Nodes made by `--set` know so and are located there.
    void add(const toml::source_region& at, std::string message);
    void add(const toml::node& at, std::string message) { add(at.source(), std::move(message)); }
    /// At the key, unless `--set` has replaced what the key stood for.
    void add_at_key(const toml::key& key, const toml::node& value, std::string message);
    void add(Diagnostics others);

    [[nodiscard]] bool empty() const { return list_.empty(); }
    /// Assignments first, then by line and column; what is wrong with other files comes last.
    [[nodiscard]] Diagnostics sorted() const;

private:
    std::string file_;
    Diagnostics list_;
};

/// A finite number that a float can hold.
std::optional<float> read_float(const toml::node& node);
/// A list of `lowest` to `highest` finite numbers.
std::optional<std::vector<float>>
read_floats(const toml::node& node, std::size_t lowest, std::size_t highest);

/// Reads one table. Keys it was never asked for are unknown keys: `finish` complains about them.
class TableReader {
public:
    /// `name` is how messages call the table: "camera", "object 2".
    TableReader(Complaints& complaints, const toml::table& table, std::string name)
        : complaints_(complaints), table_(table), name_(std::move(name)) {}

    /// The entry, or null. From then on the key is known.
    const toml::node* find(std::string_view key);
    [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }

    // Each reads into `target` and returns true, or leaves it as it is: without complaint when
    // there is no such key.
    bool read(std::string_view key, bool& target);
    bool read(std::string_view key, float& target);
    bool read(std::string_view key, int& target, int lowest, int highest);
    bool read(std::string_view key, std::string& target);
    bool read(std::string_view key, glm::vec3& target);
    template <typename Enum>
    bool read_choice(std::string_view key, Enum& target) {
        std::vector<std::string_view> choices;
        for (const Named<Enum>& row : names<Enum>()) {
            choices.push_back(row.name);
        }
        const std::optional<std::string> text = read_one_of(key, choices);
        if (text) {
            target = *parse_name<Enum>(*text);
        }
        return text.has_value();
    }

    const toml::table* read_table(std::string_view key);
    const toml::array* read_array(std::string_view key, std::string_view expected);

    /// "camera.eye must be …": located at the entry.
    void must_be(std::string_view key, std::string_view expected);
    void complain(std::string message);
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] Complaints& complaints() { return complaints_; }

    void finish();

private:
    std::optional<std::string>
    read_one_of(std::string_view key, std::span<const std::string_view> choices);

    Complaints& complaints_;
    const toml::table& table_;
    std::string name_;
    std::vector<std::string_view> known_;
};

} // namespace hs::scene::file
