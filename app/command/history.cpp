// `halfspace history`: everything that happened to a pixel.
#include "core/trace/history.hpp"

#include "app/command/command.hpp"
#include "core/export/whole_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace hs::command {
namespace {

struct Options {
    std::filesystem::path file;
    std::string pixel;
    std::string at;
    std::filesystem::path out;
};

/// Rows decided up to the step the playhead stands on.
void forget_the_future(trace::PixelHistory& history, const trace::Player& player) {
    while (!history.rows.empty() && history.rows.back().fragment >= player.fragments_done()) {
        history.final_color = history.rows.back().before;
        history.final_depth = history.rows.back().stored_depth;
        history.rows.pop_back();
    }
}

std::string color_text(const glm::vec4& c) {
    return fmt::format("{:.4f} {:.4f} {:.4f} {:.4f}", c.r, c.g, c.b, c.a);
}

std::string as_table(const trace::PixelHistory& history) {
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(
        out,
        "pixel {},{} counted from the top left\n{:>10} {:>7} {:>9} {:>11} {:>11}  {:<14} {}\n",
        history.pixel.x,
        history.pixel.y,
        "fragment",
        "object",
        "triangle",
        "depth",
        "stored",
        "fate",
        "color after"
    );
    fmt::format_to(
        out,
        "{:>10} {:>7} {:>9} {:>11} {:>11.8f}  {:<14} {}\n",
        "initial",
        "",
        "",
        "",
        history.initial_depth,
        "",
        color_text(history.initial_color)
    );
    for (const trace::HistoryRow& row : history.rows) {
        fmt::format_to(
            out,
            "{:>10} {:>7} {:>9} {:>11.8f} {:>11.8f}  {:<14} {}\n",
            row.fragment,
            row.object,
            row.triangle,
            row.depth,
            row.stored_depth,
            name_of(row.fate),
            color_text(row.after)
        );
    }
    fmt::format_to(
        out,
        "{:>10} {:>7} {:>9} {:>11} {:>11.8f}  {:<14} {}\n",
        "final",
        "",
        "",
        "",
        history.final_depth,
        "",
        color_text(history.final_color)
    );
    return fmt::to_string(text);
}

std::string as_csv(const trace::PixelHistory& history) {
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(
        out, "fragment,object,triangle,depth,stored_depth,fate,after.r,after.g,after.b,after.a\n"
    );
    for (const trace::HistoryRow& row : history.rows) {
        fmt::format_to(
            out,
            "{},{},{},{},{},{},{},{},{},{}\n",
            row.fragment,
            row.object,
            row.triangle,
            row.depth,
            row.stored_depth,
            name_of(row.fate),
            row.after.r,
            row.after.g,
            row.after.b,
            row.after.a
        );
    }
    return fmt::to_string(text);
}

nlohmann::ordered_json color_json(const glm::vec4& c) {
    return {c.r, c.g, c.b, c.a};
}

std::string as_json(const trace::PixelHistory& history) {
    nlohmann::ordered_json document{
        {"pixel", {history.pixel.x, history.pixel.y}},
        {"initial",
         {{"color", color_json(history.initial_color)}, {"depth", history.initial_depth}}},
        {"fragments", nlohmann::ordered_json::array()}};
    for (const trace::HistoryRow& row : history.rows) {
        document["fragments"].push_back(
            {{"fragment", row.fragment},
             {"object", row.object},
             {"triangle", row.triangle},
             {"depth", row.depth},
             {"stored_depth", row.stored_depth},
             {"before", color_json(row.before)},
             {"after", color_json(row.after)},
             {"fate", name_of(row.fate)}}
        );
    }
    document["final"] = {
        {"color", color_json(history.final_color)}, {"depth", history.final_depth}};
    return document.dump() + '\n';
}

int run_history(const Options& options, const Common& common) {
    const Result<PixelPos> pixel = parse_pixel(options.pixel);
    if (!pixel) {
        return fail(pixel.diagnostics());
    }
    const auto recording = record_input(options.file, common);
    if (!recording) {
        return fail(recording.diagnostics());
    }
    const auto player = stand_on(*recording, options.at);
    if (!player) {
        return fail(player.diagnostics());
    }
    if (!(*recording)->settings().image().contains(*pixel)) {
        return fail(
            {{.file = "--pixel",
              .message = fmt::format(
                  "{},{} lies outside the image; pixels are 0,0 to {},{}",
                  pixel->x,
                  pixel->y,
                  (*recording)->width() - 1,
                  (*recording)->height() - 1
              )}}
        );
    }
    trace::PixelHistory history = trace::pixel_history(**recording, *pixel);
    forget_the_future(history, **player);

    if (!options.out.empty()) {
        const bool json = options.out.extension() == ".json";
        if (!json && options.out.extension() != ".csv") {
            return fail({{.file = options.out.string(), .message = "history writes .csv or .json"}}
            );
        }
        const Result<Done> written =
            exporting::write_text(options.out, json ? as_json(history) : as_csv(history));
        return written ? status_done : fail(written.diagnostics());
    }
    fmt::print("{}", common.json ? as_json(history) : as_table(history));
    return status_done;
}

} // namespace

Command add_history(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app = program.add_subcommand("history", "List everything that happened to a pixel");
    app->add_option("FILE", options->file, "scene, mesh or lesson")->required();
    app->add_option("--pixel", options->pixel, "X,Y, counted from the top left")->required();
    app->add_option("--at", options->at, "up to this step; default: the end");
    app->add_option("-o,--output", options->out, "write to .csv or .json instead of printing");
    return {app, [options, &common] { return run_history(*options, common); }};
}

} // namespace hs::command
