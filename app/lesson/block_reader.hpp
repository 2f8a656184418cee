// The TOML inside a lesson's fenced blocks. With scenes' tables it shares reader and messages.
#pragma once

#include "app/lesson/lesson.hpp"
#include "app/lesson/markdown.hpp"
#include "core/scene/file/table_reader.hpp"

#include <optional>
#include <string>
#include <vector>

namespace hs::lesson {

using scene::file::Complaints;
using scene::file::TableReader;

/// The block as TOML, its nodes located in the lesson's file; nothing, with a complaint, when it
/// does not parse.
std::optional<toml::table>
parse_block(const FencedBlock& block, const std::string& file, Complaints& complaints);

/// Title, order, prerequisites, minutes, objectives.
void read_header(const toml::table& table, Place place, Lesson& lesson, Complaints& complaints);

/// One block of a step; a step may have several.
void read_step_block(
    const toml::table& table, Place place, LessonStep& step, Complaints& complaints
);

// Shared by the files that read parts of a block.

Place place_of(const toml::node& node);

/// A list of strings, or one string.
void read_strings(TableReader& table, std::string_view key, std::vector<std::string>& target);

/// A finite number.
bool read_number(TableReader& table, std::string_view key, double& target);

/// `{ depth.test = "less", camera.eye = [0, 0, 3] }` as assignments, one per leaf.
void read_assignments(
    TableReader& table, std::string_view key, std::vector<scene::Assignment>& target
);

/// What is wrong with the path of an assignment, as far as that shows without the scene.
std::optional<std::string> describe_unknown_setting(std::string_view path);

/// A value as TOML text.
std::string toml_text(const toml::node& node);

/// `{ quantity = "ndc.x", of = "vertex 1" }`. Complains when the key is missing and `required`.
std::optional<Expression> read_expression(TableReader& table, std::string_view key, bool required);

/// The same, of the keys of a table that may hold others, too.
std::optional<Expression> read_expression_keys(TableReader& table, Place place);

std::optional<Question> read_question(const toml::table& table, Complaints& complaints);
std::optional<Change> read_change(const toml::table& table, Complaints& complaints);
std::optional<Check> read_check(const toml::table& table, Complaints& complaints);

} // namespace hs::lesson
