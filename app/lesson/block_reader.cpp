#include "app/lesson/block_reader.hpp"

#include "app/lesson/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace hs::lesson {

namespace {

void flatten(
    const toml::table& table, const std::string& prefix, std::vector<scene::Assignment>& target
) {
    for (const auto& [key, node] : table) {
        const std::string path =
            prefix.empty() ? std::string{key.str()} : prefix + "." + std::string{key.str()};
        if (const toml::table* const inner = node.as_table()) {
            flatten(*inner, path, target);
        } else {
            target.push_back({path, toml_text(node)});
        }
    }
}

/// Paths into a scene begin with one of these words; any other path is a setting's.
constexpr std::array<std::string_view, 6> scene_words{
    "name", "settings", "camera", "object", "material", "light"};

/// Highlights and things to hide are quantities or their first words.
void read_quantities(TableReader& table, std::string_view key, std::vector<std::string>& target) {
    read_strings(table, key, target);
    for (const std::string& name : target) {
        if (!is_quantity_or_group(name)) {
            table.complaints().add(*table.find(key), describe_unknown_quantity(name));
        }
    }
}

/// Calls `read` for each table of `[[key]]`.
template <typename Read>
void read_tables(TableReader& table, std::string_view key, Read read) {
    const toml::array* const entries =
        table.read_array(key, fmt::format("written as [[{}]], with two brackets", key));
    if (entries == nullptr) {
        return;
    }
    for (const toml::node& entry : *entries) {
        if (const toml::table* const inner = entry.as_table()) {
            read(*inner);
        } else {
            table.must_be(key, fmt::format("written as [[{}]], with two brackets", key));
        }
    }
}

/// A key given in two blocks of one step.
void refuse_twice(TableReader& table, std::string_view key, bool said_before) {
    const toml::node* const node = table.find(key);
    if (node != nullptr && said_before) {
        table.complaints().add(*node, fmt::format("{} was already said in this step", key));
    }
}

} // namespace

std::optional<std::string> describe_unknown_setting(std::string_view path) {
    const std::string_view word = path.substr(0, path.find('.'));
    const bool prefixed = word == "settings" && word != path;
    const std::string_view key = prefixed ? path.substr(word.size() + 1) : path;
    const bool elsewhere = !prefixed && std::ranges::find(scene_words, word) != scene_words.end();
    if (elsewhere || scene::find_setting(key) != nullptr) {
        return std::nullopt;
    }
    std::vector<std::string_view> known;
    for (const scene::SettingInfo& setting : scene::setting_infos()) {
        known.push_back(setting.key);
    }
    return fmt::format("there is no setting \"{}\"{}", key, did_you_mean(key, known));
}

Place place_of(const toml::node& node) {
    return {
        static_cast<int>(node.source().begin.line), static_cast<int>(node.source().begin.column)};
}

std::string toml_text(const toml::node& node) {
    std::ostringstream text;
    node.visit([&text](const auto& typed) { text << typed; });
    return text.str();
}

void read_strings(TableReader& table, std::string_view key, std::vector<std::string>& target) {
    const toml::node* const node = table.find(key);
    if (node == nullptr) {
        return;
    }
    if (const auto* const text = node->as_string()) {
        target.push_back(text->get());
        return;
    }
    const toml::array* const list = node->as_array();
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
        if (const auto* const text = list->get(i)->as_string()) {
            target.push_back(text->get());
        } else {
            table.must_be(key, "a list of texts");
            return;
        }
    }
    if (list == nullptr) {
        table.must_be(key, "a list of texts");
    }
}

bool read_number(TableReader& table, std::string_view key, double& target) {
    const toml::node* const node = table.find(key);
    if (node == nullptr) {
        return false;
    }
    const std::optional<double> number = node->value<double>();
    if (!number || !scene::file::read_float(*node)) {
        table.must_be(key, "a finite number");
        return false;
    }
    target = *number;
    return true;
}

void read_assignments(
    TableReader& table, std::string_view key, std::vector<scene::Assignment>& target
) {
    const toml::table* const settings = table.read_table(key);
    if (settings == nullptr) {
        return;
    }
    flatten(*settings, "", target);
    for (const scene::Assignment& assignment : target) {
        if (const std::optional<std::string> problem = describe_unknown_setting(assignment.path)) {
            table.complaints().add(*settings, *problem);
        }
    }
}

std::optional<Expression> read_expression_keys(TableReader& table, Place place) {
    Expression expression;
    expression.place = place;
    if (!table.read("quantity", expression.quantity)) {
        if (!table.has("quantity")) {
            table.complain("a quantity is missing: quantity = \"ndc.x\"");
        }
        return std::nullopt;
    }
    constexpr std::string_view counted = "number of ";
    const std::string_view quantity = expression.quantity;
    const std::string_view name =
        quantity.starts_with(counted) ? quantity.substr(counted.size()) : quantity;
    if (find_quantity(name) == nullptr) {
        table.complaints().add(*table.find("quantity"), describe_unknown_quantity(name));
    }
    if (table.read("of", expression.of)) {
        if (const Result<Subject> subject = parse_subject(expression.of); !subject) {
            table.complaints().add(*table.find("of"), subject.diagnostics().front().message);
        }
    }
    read_number(table, "times", expression.times);
    read_number(table, "plus", expression.plus);
    read_assignments(table, "settings", expression.settings);
    return expression;
}

std::optional<Expression> read_expression(TableReader& table, std::string_view key, bool required) {
    const std::string_view shape = R"({ quantity = "ndc.x", of = "vertex 1" })";
    if (!table.has(key)) {
        if (required) {
            table.complain(fmt::format("{} is missing: {} = {}", key, key, shape));
        }
        return std::nullopt;
    }
    const toml::node& node = *table.find(key);
    const toml::table* const inner = node.as_table();
    if (inner == nullptr) {
        table.must_be(key, fmt::format("an expression over the trace: {}", shape));
        return std::nullopt;
    }
    TableReader reader(table.complaints(), *inner, std::string{key});
    std::optional<Expression> expression = read_expression_keys(reader, place_of(node));
    reader.finish();
    return expression;
}

std::optional<toml::table>
parse_block(const FencedBlock& block, const std::string& file, Complaints& complaints) {
    // Blank lines in front give every node the line it has in the file
    const std::string blank(static_cast<std::size_t>(block.first_line) - 1, '\n');
    try {
        return toml::parse(blank + block.text, file);
    } catch (const toml::parse_error& error) {
        complaints.add(error.source(), std::string{error.description()});
        return std::nullopt;
    }
}

void read_header(const toml::table& table, Place place, Lesson& lesson, Complaints& complaints) {
    TableReader reader(complaints, table, "the lesson's first block");
    const auto need = [&](std::string_view key, bool present) {
        if (!present && !reader.has(key)) {
            complaints.add(Diagnostics{
                {lesson.file.string(),
                 place.line,
                 place.column,
                 fmt::format("the lesson's first block needs {}", key)}});
        }
    };
    need("title", reader.read("title", lesson.title));
    need("minutes", reader.read("minutes", lesson.minutes, 1, 600));
    reader.read("order", lesson.order, 0, 100'000);
    read_strings(reader, "prerequisites", lesson.prerequisites);
    read_strings(reader, "objectives", lesson.objectives);
    need("objectives", !lesson.objectives.empty());
    reader.finish();
}

void read_step_block(
    const toml::table& table, Place place, LessonStep& step, Complaints& complaints
) {
    TableReader reader(complaints, table, "this block");
    refuse_twice(reader, "scene", !step.scene.empty());
    refuse_twice(reader, "step", !step.stand.empty());
    refuse_twice(reader, "question", step.question.has_value());
    refuse_twice(reader, "note", !step.note.empty());
    const auto place_at = [&](std::string_view key) {
        return reader.has(key) ? place_of(*reader.find(key)) : place;
    };

    // Where to stand
    if (reader.read("scene", step.scene)) {
        step.scene_place = place_at("scene");
    }
    if (reader.has("settings")) {
        step.settings_place = place_at("settings");
        read_assignments(reader, "settings", step.settings);
    }
    if (reader.read("step", step.stand)) {
        step.stand_place = place_at("step");
    }

    // What to look at
    reader.read_choice("view", step.view);
    reader.read_choice("panel", step.panel);
    read_quantities(reader, "highlight", step.highlight);
    read_quantities(reader, "hide", step.hide);
    reader.read("note", step.note);

    // What to answer, to change, to verify
    if (const toml::table* const question = reader.read_table("question")) {
        step.question = read_question(*question, complaints);
    }
    read_tables(reader, "change", [&](const toml::table& inner) {
        if (std::optional<Change> change = read_change(inner, complaints)) {
            step.changes.push_back(std::move(*change));
        }
    });
    read_tables(reader, "check", [&](const toml::table& inner) {
        if (std::optional<Check> check = read_check(inner, complaints)) {
            step.checks.push_back(std::move(*check));
        }
    });
    reader.finish();
}

} // namespace hs::lesson
