// Questions, changes and checks out of a lesson's fenced blocks.
#include "app/lesson/block_reader.hpp"

#include <fmt/format.h>

#include <array>

namespace hs::lesson {

namespace {

/// A text that must be there.
bool need_text(TableReader& table, std::string_view key, std::string& target) {
    if (!table.has(key)) {
        table.complain(fmt::format("{} is missing", key));
        return false;
    }
    return table.read(key, target);
}

/// `["yes", "no"]`, or `[{ text = "It passes", value = "yes" }, …]`.
void read_choices(TableReader& table, std::vector<Choice>& choices) {
    const toml::array* const list = table.read_array("choices", "a list");
    if (list == nullptr) {
        return;
    }
    for (const toml::node& node : *list) {
        Choice choice;
        if (const toml::table* const inner = node.as_table()) {
            TableReader reader(table.complaints(), *inner, "a choice");
            need_text(reader, "text", choice.text);
            need_text(reader, "value", choice.value);
            reader.finish();
        } else if (const auto* const text = node.as_string()) {
            choice = {text->get(), text->get()};
        } else {
            choice = {toml_text(node), toml_text(node)};
        }
        choices.push_back(std::move(choice));
    }
}

/// `region = [x, y, width, height]`.
void read_region(TableReader& table, std::optional<PixelRect>& region) {
    const toml::node* const node = table.find("region");
    if (node == nullptr) {
        return;
    }
    constexpr std::string_view expected = "[x, y, width, height] in whole pixels";
    constexpr std::int64_t largest = 1 << 16;
    const toml::array* const list = node->as_array();
    std::array<int, 4> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto* const number =
            list != nullptr && list->size() == 4 ? list->get(i)->as_integer() : nullptr;
        if (number == nullptr || number->get() < 0 || number->get() > largest) {
            table.must_be("region", expected);
            return;
        }
        numbers[i] = static_cast<int>(number->get());
    }
    region = PixelRect{numbers[0], numbers[1], numbers[0] + numbers[2], numbers[1] + numbers[3]};
}

std::optional<WrongAnswer> read_wrong(const toml::table& table, Complaints& complaints) {
    TableReader reader(complaints, table, "a wrong answer");
    WrongAnswer wrong;
    wrong.place = place_of(table);
    need_text(reader, "misconception", wrong.misconception);
    need_text(reader, "message", wrong.message);
    reader.read("choice", wrong.choice);
    wrong.answer = read_expression(reader, "answer", false);
    if (reader.has("answer") == reader.has("choice")) {
        reader.complain("a wrong answer has either an answer, computed, or a choice");
    }
    reader.finish();
    return wrong;
}

/// What only some kinds have, and none may go without.
void complete_kind(TableReader& table, Question& question) {
    const bool picks = question.kind == QuestionKind::choice;
    const bool decides = question.kind == QuestionKind::pass_fail;
    if (decides && question.choices.empty()) {
        question.choices = {{"yes", "yes"}, {"no", "no"}};
    }
    if (picks && question.choices.size() < 2) {
        table.complain("a choice needs at least two choices");
    }
    if (!picks && !decides && !question.choices.empty()) {
        table.complain("only the kinds choice and pass-fail have choices");
    }
    if (question.kind != QuestionKind::value && table.has("tolerance")) {
        table.complain("only the kind value has a tolerance");
    }
    if (question.kind != QuestionKind::pixels && question.region) {
        table.complain("only the kind pixels has a region");
    }
}

} // namespace

std::optional<Question> read_question(const toml::table& table, Complaints& complaints) {
    TableReader reader(complaints, table, "the question");
    Question question;
    question.place = place_of(table);
    if (!reader.has("kind")) {
        reader.complain("kind is missing: choice, value, pixels or pass-fail");
    }
    reader.read_choice("kind", question.kind);
    need_text(reader, "prompt", question.prompt);
    need_text(reader, "reveal", question.reveal);
    read_number(reader, "tolerance", question.tolerance);
    if (question.tolerance < 0.0) {
        reader.must_be("tolerance", "0 or more");
    }
    reader.read("unit", question.unit);
    read_choices(reader, question.choices);
    read_region(reader, question.region);
    const std::optional<Expression> answer = read_expression(reader, "answer", true);
    if (const toml::array* const wrong =
            reader.read_array("wrong", "written as [[question.wrong]]")) {
        for (const toml::node& node : *wrong) {
            if (const toml::table* const inner = node.as_table()) {
                question.wrong.push_back(*read_wrong(*inner, complaints));
            }
        }
    }
    complete_kind(reader, question);
    reader.finish();
    if (!answer) {
        return std::nullopt;
    }
    question.answer = *answer;
    return question;
}

std::optional<Change> read_change(const toml::table& table, Complaints& complaints) {
    TableReader reader(complaints, table, "a change");
    Change change;
    change.place = place_of(table);
    need_text(reader, "prompt", change.prompt);
    if (need_text(reader, "key", change.key)) {
        if (const std::optional<std::string> problem = describe_unknown_setting(change.key)) {
            complaints.add(*reader.find("key"), *problem);
        }
    }
    const toml::array* const values =
        reader.read_array("values", "a list of values to choose from");
    for (std::size_t i = 0; values != nullptr && i < values->size(); ++i) {
        const auto* const text = values->get(i)->as_string();
        change.values.push_back(text != nullptr ? text->get() : toml_text(*values->get(i)));
    }
    if (change.values.size() < 2) {
        reader.complain("a change needs at least two values to choose from");
    }
    read_strings(reader, "labels", change.labels);
    if (!change.labels.empty() && change.labels.size() != change.values.size()) {
        reader.complain("a change needs as many labels as values, or none");
    }
    const std::optional<Expression> watch = read_expression(reader, "watch", true);
    reader.finish();
    if (!watch) {
        return std::nullopt;
    }
    change.watch = *watch;
    return change;
}

std::optional<Check> read_check(const toml::table& table, Complaints& complaints) {
    TableReader reader(complaints, table, "a check");
    Check check;
    check.place = place_of(table);
    need_text(reader, "claim", check.claim);
    read_number(reader, "tolerance", check.tolerance);
    const std::optional<Expression> left = read_expression_keys(reader, check.place);
    struct Row {
        std::string_view key;
        Check::Relation relation;
    };
    static constexpr std::array<Row, 3> relations{{
        {"equals", Check::Relation::equals},
        {"less_than", Check::Relation::less_than},
        {"greater_than", Check::Relation::greater_than},
    }};
    int found = 0;
    for (const Row& row : relations) {
        const toml::node* const node = reader.find(row.key);
        if (node == nullptr) {
            continue;
        }
        ++found;
        check.relation = row.relation;
        if (node->is_table()) {
            check.right = read_expression(reader, row.key, true);
        } else if (const auto* const truth = node->as_boolean()) {
            check.literal = truth->get() ? "yes" : "no";
        } else {
            check.literal = node->is_string() ? **node->as_string() : toml_text(*node);
        }
    }
    if (found != 1) {
        reader.complain("a check has one of equals, less_than, greater_than");
    }
    reader.finish();
    if (!left) {
        return std::nullopt;
    }
    check.left = *left;
    return check;
}

} // namespace hs::lesson
