// `halfspace history`: everything that happened to a pixel.
#include "core/trace/history.hpp"

#include "app/command/command.hpp"
#include "core/export/whole_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>
#include <limits>

namespace hs::command {
namespace {

struct Options {
    std::filesystem::path file;
    std::string pixel;
    std::string at;
    bool csv = false;
    std::filesystem::path out;
};

/// A pixel's fragments up to a step, and the steps they ended with.
struct Story {
    const trace::Recording& recording;
    trace::PixelHistory history;
    std::vector<trace::Step> ends; ///< by row
};

Story tell(const trace::Player& player, PixelPos pixel) {
    constexpr std::size_t everything = std::numeric_limits<std::size_t>::max();
    const trace::Recording& recording = player.recording();
    Story story{recording, trace::pixel_history(recording, pixel, everything), {}};

    // Forget what comes after the step
    trace::PixelHistory& history = story.history;
    while (!history.rows.empty() && history.rows.back().fragment >= player.fragments_done()) {
        history.final_color = history.rows.back().before;
        history.final_depth = history.rows.back().stored_depth;
        history.rows.pop_back();
    }
    for (const trace::HistoryRow& row : history.rows) {
        story.ends.push_back(
            trace::describe_step(recording, trace::last_step_of_fragment(recording, row.fragment))
        );
    }
    return story;
}

std::string color_text(const glm::vec4& c) {
    return fmt::format("{:.4f} {:.4f} {:.4f} {:.4f}", c.r, c.g, c.b, c.a);
}

/// A line of the table; empty texts leave their column blank.
std::string table_line(
    std::string_view step,
    std::string_view triangle,
    std::string_view depths,
    std::string_view fate,
    std::string_view color
) {
    return fmt::format("{:>12}  {:<26} {:>23}  {:<14}  {}\n", step, triangle, depths, fate, color);
}

std::string as_table(const Story& story) {
    const trace::PixelHistory& history = story.history;
    std::string text =
        fmt::format("pixel {},{} counted from the top left\n", history.pixel.x, history.pixel.y);
    text += table_line("step", "", "depth      stored", "fate", "color after: r g b a");
    text += table_line(
        "",
        "before",
        fmt::format("{:.8f}", history.initial_depth),
        "",
        color_text(history.initial_color)
    );
    for (std::size_t i = 0; i < history.rows.size(); ++i) {
        const trace::HistoryRow& row = history.rows[i];
        text += table_line(
            fmt::format("#{}", story.ends[i].id),
            trace::primitive_path(story.recording, row.object, row.triangle),
            fmt::format("{:.8f}  {:.8f}", row.depth, row.stored_depth),
            name_of(row.fate),
            color_text(row.after)
        );
    }
    text += table_line(
        "", "after", fmt::format("{:.8f}", history.final_depth), "", color_text(history.final_color)
    );
    return text;
}

std::string as_csv(const Story& story) {
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(
        out,
        "step,fragment,object,triangle,depth,stored_depth,fate,before.r,before.g,before.b,before.a,"
        "after.r,after.g,after.b,after.a\n"
    );
    for (std::size_t i = 0; i < story.ends.size(); ++i) {
        const trace::HistoryRow& row = story.history.rows[i];
        fmt::format_to(
            out, "{},{},{},{}", story.ends[i].id, row.fragment, row.object, row.triangle
        );
        fmt::format_to(out, ",{},{},{}", row.depth, row.stored_depth, name_of(row.fate));
        for (const glm::vec4& color : {row.before, row.after}) {
            fmt::format_to(out, ",{},{},{},{}", color.r, color.g, color.b, color.a);
        }
        fmt::format_to(out, "\n");
    }
    return fmt::to_string(text);
}

nlohmann::ordered_json color_json(const glm::vec4& c) {
    return {c.r, c.g, c.b, c.a};
}

std::string as_json(const Story& story) {
    const trace::PixelHistory& history = story.history;
    nlohmann::ordered_json document{
        {"pixel", {history.pixel.x, history.pixel.y}},
        {"before",
         {{"color", color_json(history.initial_color)}, {"depth", history.initial_depth}}},
        {"fragments", nlohmann::ordered_json::array()}};
    for (std::size_t i = 0; i < story.ends.size(); ++i) {
        const trace::HistoryRow& row = history.rows[i];
        document["fragments"].push_back(
            {{"step", story.ends[i].id},
             {"path", trace::step_path(story.ends[i])},
             {"fragment", row.fragment},
             {"object", row.object},
             {"triangle", row.triangle},
             {"depth", row.depth},
             {"stored_depth", row.stored_depth},
             {"before", color_json(row.before)},
             {"after", color_json(row.after)},
             {"fate", name_of(row.fate)}}
        );
    }
    document["after"] = {
        {"color", color_json(history.final_color)}, {"depth", history.final_depth}};
    return document.dump() + '\n';
}

/// Everything that can be refused before the frame is recorded.
Result<PixelPos> check_options(const Options& options) {
    if (!options.out.empty()) {
        if (const auto format = output_format(options.out, {".csv", ".json"}); !format) {
            return format.diagnostics();
        }
        if (const Result<Done> good = exporting::check_writable(options.out); !good) {
            return good.diagnostics();
        }
    }
    return parse_pixel(options.pixel);
}

int show(const Story& story, const Options& options, const Common& common) {
    if (!options.out.empty()) {
        const bool json = options.out.extension() == ".json";
        const Result<Done> written =
            exporting::write_text(options.out, json ? as_json(story) : as_csv(story));
        return written ? status_done : fail(written.diagnostics());
    }
    return print(common.json ? as_json(story) : options.csv ? as_csv(story) : as_table(story));
}

int run_history(const Options& options, const Common& common) {
    const Result<PixelPos> pixel = check_options(options);
    if (!pixel) {
        return fail(pixel.diagnostics());
    }
    const auto recording = record_file(options.file, common);
    if (!recording) {
        return fail(recording.diagnostics());
    }
    const auto player = stand_on(*recording, options.at);
    if (!player) {
        return fail(player.diagnostics());
    }
    if (!(*recording)->settings().image().contains(*pixel)) {
        return fail({outside_image(*pixel, **recording)});
    }
    return show(tell(**player, *pixel), options, common);
}

} // namespace

Command add_history(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app = program.add_subcommand("history", "List everything that happened to a pixel");
    app->footer("Example:\n  halfspace history scene.toml --pixel 31,17 --json");
    app->add_option("FILE", options->file, file_help)->required();
    app->add_option("--pixel", options->pixel, "X,Y, counted from the top left")->required();
    app->add_option("--at", options->at, "only what happened up to this step");
    app->add_flag("--csv", options->csv, "print CSV instead of a table");
    app->add_option("-o,--output", options->out, "write to .csv or .json instead of printing");
    return {app, [options, &common] { return run_history(*options, common); }, true};
}

} // namespace hs::command
