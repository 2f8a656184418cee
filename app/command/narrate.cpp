// `halfspace narrate`: the sentence of every step, line by line, as the window shows them and a
// screen reader reads them.
#include "app/command/command.hpp"
#include "app/command/interrupt.hpp"
#include "core/base/spelling.hpp"
#include "core/explain/sentence.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>

namespace hs::command {
namespace {

struct Options {
    std::filesystem::path file;
    std::string from = "start";
    std::string to = "end";
    std::string by = "operation";
};

std::string line_of(const trace::Player& player, bool json, bool first) {
    const std::string path = trace::step_path(player.current());
    if (!json) {
        return fmt::format("#{} {}: {}\n", player.step(), path, explain::sentence(player));
    }
    const nlohmann::ordered_json entry{
        {"step", player.step()}, {"path", path}, {"sentence", explain::sentence(player)}};
    return (first ? "" : ",\n") + entry.dump();
}

Result<trace::Granularity> granularity_of(const std::string& text) {
    if (const auto parsed = parse_name<trace::Granularity>(text)) {
        return *parsed;
    }
    std::vector<std::string_view> known;
    for (const auto& row : names<trace::Granularity>()) {
        known.push_back(row.name);
    }
    return Diagnostic{
        .file = "--by",
        .message = fmt::format("'{}' is none of {}", text, list_of_choices(known))};
}

/// Tells from where the player stands up to a step.
int tell(trace::Player& player, trace::StepId last, trace::Granularity by, bool json) {
    constexpr std::size_t enough = std::size_t{1} << 16U; // bytes to print at once
    std::string text = json ? "[" : "";
    bool first = true;
    while (player.step() <= last && !stop_requested()) {
        text += line_of(player, json, first);
        first = false;
        if (text.size() >= enough) {
            const int status = print(text);
            if (status != status_done || std::ferror(stdout) != 0) {
                return status; // the disk is full, or nobody reads on
            }
            text.clear();
        }
        if (!player.advance(by, trace::Direction::forward)) {
            break;
        }
    }
    return print(text + (json ? "]\n" : ""));
}

int run_narrate(const Options& options, const Common& common) {
    const auto by = granularity_of(options.by);
    if (!by) {
        return fail(by.diagnostics());
    }
    const auto recording = record_file(options.file, common);
    if (!recording) {
        return fail(recording.diagnostics());
    }
    const auto from = stand_on(*recording, options.from);
    if (!from) {
        return fail(from.diagnostics());
    }
    const auto to = stand_on(*recording, options.to);
    if (!to) {
        return fail(to.diagnostics());
    }
    return tell(**from, (*to)->step(), *by, common.json);
}

} // namespace

Command add_narrate(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app =
        program.add_subcommand("narrate", "Print the sentence of every step, line by line");
    app->footer("Examples:\n"
                "  halfspace narrate scene.toml --by triangle\n"
                "  halfspace narrate scene.toml --from 'object 0 / triangle 3 / setup' --to '#900'");
    app->add_option("FILE", options->file, file_help)->required();
    app->add_option("--from", options->from, "the first step; without it start");
    app->add_option("--to", options->to, "the last step; without it end");
    app->add_option(
        "--by",
        options->by,
        "how far from sentence to sentence: stage, object, triangle, scanline, fragment or "
        "operation"
    );
    return {app, [options, &common] { return run_narrate(*options, common); }, true};
}

} // namespace hs::command
