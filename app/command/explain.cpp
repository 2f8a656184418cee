// `halfspace explain`: the values of a step, or one of them with its formula and where each operand
// came from.
#include "app/command/command.hpp"
#include "core/base/spelling.hpp"
#include "core/explain/sentence.hpp"
#include "core/explain/step_values.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace hs::command {
namespace {

using explain::Expression;
using explain::ExpressionPtr;
using explain::StepValue;

struct Options {
    std::filesystem::path file;
    std::string at;
    std::string value;
};

std::string with_unit(const Expression& expression) {
    const std::string_view unit = explain::unit_of(expression);
    return explain::value_text(expression) + (unit.empty() ? "" : " ") + std::string{unit};
}

/// Pads to a width in characters: symbols are not all one byte long.
std::string padded(std::string text, std::size_t width) {
    const std::size_t characters = explain::width(text);
    return text.append(width > characters ? width - characters : 0, ' ');
}

/// A line without blanks at its end.
std::string line_of(std::string text) {
    text.erase(text.find_last_not_of(' ') + 1);
    return text + '\n';
}

std::string as_list(const std::vector<StepValue>& values) {
    constexpr std::size_t name_column = 24;
    constexpr std::size_t value_column = 18;
    std::string text;
    for (const StepValue& value : values) {
        text += fmt::format(
            "  {} {} = {}\n",
            padded(value.name, name_column),
            padded(with_unit(*value.expression), value_column),
            explain::in_symbols(*value.expression)
        );
    }
    return text;
}

std::string as_explanation(const StepValue& value) {
    const Expression& expression = *value.expression;
    std::string text = fmt::format(
        "  {} = {}\n  {} = {}\n  {} = {}\n",
        value.name,
        explain::in_symbols(expression),
        padded("", explain::width(value.name)),
        explain::in_numbers(expression),
        padded("", explain::width(value.name)),
        with_unit(expression)
    );
    text += line_of(fmt::format(
        "  exactly {} {}", explain::exact_text(expression), explain::unit_of(expression)
    ));
    for (const ExpressionPtr& operand : explain::operands_of(value.expression)) {
        constexpr std::size_t name_column = 18;
        constexpr std::size_t value_column = 18;
        text += line_of(fmt::format(
            "  {} {} {}",
            padded(operand->symbol, name_column),
            padded(with_unit(*operand), value_column),
            explain::origin_text(operand->origin)
        ));
    }
    return text;
}

/// In the unit that is printed beside it; what JSON has no number for is null.
nlohmann::ordered_json number_json(const Expression& e) {
    const double scale = std::exp2(-8.0 * e.subpixels);
    return std::visit(
        [scale](auto number) -> nlohmann::ordered_json {
            using T = decltype(number);
            if constexpr (std::is_same_v<T, bool>) {
                return number;
            } else if constexpr (std::is_same_v<T, std::int64_t>) {
                return scale == 1.0 ? nlohmann::ordered_json(number)
                                    : nlohmann::ordered_json(static_cast<double>(number) * scale);
            } else {
                const double real = static_cast<double>(number) * scale;
                return std::isfinite(real) ? nlohmann::ordered_json(real) : nullptr;
            }
        },
        e.value
    );
}

nlohmann::ordered_json operand_json(const Expression& operand) {
    nlohmann::ordered_json entry{
        {"symbol", operand.symbol},
        {"value", number_json(operand)},
        {"unit", explain::unit_of(operand)}};
    if (operand.origin.step.empty()) {
        entry["given"] = operand.origin.given;
    } else {
        entry["step"] = operand.origin.step;
        entry["name"] = operand.origin.value;
    }
    return entry;
}

nlohmann::ordered_json value_json(const StepValue& value) {
    nlohmann::ordered_json entry{
        {"name", value.name},
        {"value", number_json(*value.expression)},
        {"unit", explain::unit_of(*value.expression)},
        {"formula", explain::in_symbols(*value.expression)},
        {"numbers", explain::in_numbers(*value.expression)},
        {"operands", nlohmann::ordered_json::array()}};
    for (const ExpressionPtr& operand : explain::operands_of(value.expression)) {
        entry["operands"].push_back(operand_json(*operand));
    }
    return entry;
}

std::string
as_json(const trace::Player& player, const std::vector<StepValue>& values, const StepValue* only) {
    nlohmann::ordered_json document{
        {"step", player.step()},
        {"path", trace::step_path(player.current())},
        {"sentence", explain::sentence(player)},
        {"values", nlohmann::ordered_json::array()}};
    for (const StepValue& value : values) {
        if (only == nullptr || only == &value) {
            document["values"].push_back(value_json(value));
        }
    }
    return document.dump() + '\n';
}

Diagnostic
no_value(const std::string& name, const std::string& path, const std::vector<StepValue>& values) {
    if (values.empty()) {
        return {.file = "VALUE", .message = path + " computes no values"};
    }
    std::vector<std::string_view> known;
    for (const StepValue& value : values) {
        known.push_back(value.name);
    }
    return {
        .file = "VALUE",
        .message = fmt::format(
            "{} has no value \"{}\"{}; 'halfspace explain FILE --at STEP' lists those it has",
            path,
            name,
            did_you_mean(name, known)
        )};
}

int run_explain(const Options& options, const Common& common) {
    const auto recording = record_file(options.file, common);
    if (!recording) {
        return fail(recording.diagnostics());
    }
    const auto standing = stand_on(*recording, options.at);
    if (!standing) {
        return fail(standing.diagnostics());
    }
    const trace::Player& player = **standing;
    const auto values =
        explain::step_values(player.recording(), player.current(), player.detail());
    const std::string path = trace::step_path(player.current());
    const StepValue* only = explain::find_value(values, options.value);
    if (!options.value.empty() && only == nullptr) {
        return fail({no_value(options.value, path, values)});
    }
    if (common.json) {
        return print(as_json(player, values, only));
    }
    if (only != nullptr) {
        return print(fmt::format("{} of {}\n{}", only->name, path, as_explanation(*only)));
    }
    return print(fmt::format("{}\n{}\n{}", path, explain::sentence(player), as_list(values)));
}

} // namespace

Command add_explain(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app = program.add_subcommand(
        "explain", "Say how the values of a step were computed, and from what"
    );
    app->footer("Examples:\n"
                "  halfspace explain scene.toml --at 'object 0 / triangle 12 / setup'\n"
                "  halfspace explain scene.toml --at 'object 0 / triangle 12 / setup' E01.c");
    app->add_option("FILE", options->file, file_help)->required();
    app->add_option("VALUE", options->value, "one of the step's values; without it all are listed");
    app->add_option("--at", options->at, "step path, #NUMBER or start")->required();
    return {app, [options, &common] { return run_explain(*options, common); }, true};
}

} // namespace hs::command
