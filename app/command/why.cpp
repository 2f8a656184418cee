// `halfspace why`: why a pixel has its color, and why other triangles do not show there.
#include "app/command/command.hpp"
#include "core/explain/numbers.hpp"
#include "core/explain/why_color.hpp"
#include "core/explain/why_not.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <optional>

namespace hs::command {
namespace {

using explain::ColorLink;
using explain::TriangleAtPixel;

struct Options {
    std::filesystem::path file;
    std::string pixel;
    std::string at;
    std::optional<std::uint32_t> triangle;
};

/// All that is said about a pixel.
struct Answer {
    const trace::Player& player;
    PixelPos pixel;
    std::vector<ColorLink> color;
    std::vector<TriangleAtPixel> triangles;
};

std::string path_of(const trace::Recording& recording, trace::StepId step) {
    return trace::step_path(trace::describe_step(recording, step));
}

std::string as_text(const Answer& answer) {
    const glm::vec4 color = answer.player.color(answer.pixel);
    std::string text = fmt::format(
        "pixel {},{} counted from the top left is {}\n",
        answer.pixel.x,
        answer.pixel.y,
        explain::point(color)
    );
    for (const ColorLink& link : answer.color) {
        const explain::Expression& expression = *link.value.expression;
        text += fmt::format(
            "  {} = {} = {} = {}\n      {}\n",
            link.value.name,
            explain::in_symbols(expression),
            explain::in_numbers(expression),
            explain::value_text(expression),
            link.path
        );
    }
    for (const TriangleAtPixel& each : answer.triangles) {
        text += fmt::format(
            "{}\n      {}\n", each.sentence, path_of(answer.player.recording(), each.step)
        );
    }
    if (answer.triangles.empty()) {
        text += "No triangle's projection holds the pixel.\n";
    }
    return text;
}

std::string as_json(const Answer& answer) {
    const trace::Recording& recording = answer.player.recording();
    const glm::vec4 color = answer.player.color(answer.pixel);
    nlohmann::ordered_json document{
        {"pixel", {answer.pixel.x, answer.pixel.y}},
        {"step", answer.player.step()},
        {"color", {color.r, color.g, color.b, color.a}},
        {"because", nlohmann::ordered_json::array()},
        {"triangles", nlohmann::ordered_json::array()}};
    for (const ColorLink& link : answer.color) {
        document["because"].push_back(
            {{"name", link.value.name},
             {"formula", explain::in_symbols(*link.value.expression)},
             {"numbers", explain::in_numbers(*link.value.expression)},
             {"value", explain::value_text(*link.value.expression)},
             {"step", link.step},
             {"path", link.path}}
        );
    }
    for (const TriangleAtPixel& each : answer.triangles) {
        document["triangles"].push_back(
            {{"triangle", each.triangle},
             {"role", name_of(each.role)},
             {"sentence", each.sentence},
             {"step", each.step},
             {"path", path_of(recording, each.step)}}
        );
    }
    return document.dump() + '\n';
}

/// What is asked does not exist in the frame.
std::optional<Diagnostic>
refused(const Options& options, PixelPos pixel, const trace::Recording& recording) {
    if (!recording.settings().image().contains(pixel)) {
        return outside_image(pixel, recording);
    }
    if (options.triangle && *options.triangle >= recording.triangles.size()) {
        return Diagnostic{
            .file = "--triangle",
            .message =
                recording.triangles.empty()
                    ? std::string{"the frame has no triangles"}
                    : fmt::format(
                          "the frame has no triangle {}; its triangles are 0 to {}",
                          *options.triangle,
                          recording.triangles.size() - 1
                      )};
    }
    return std::nullopt;
}

int run_why(const Options& options, const Common& common) {
    const Result<PixelPos> pixel = parse_pixel(options.pixel);
    if (!pixel) {
        return fail(pixel.diagnostics());
    }
    const auto recording = record_file(options.file, common);
    if (!recording) {
        return fail(recording.diagnostics());
    }
    const auto standing = stand_on(*recording, options.at);
    if (!standing) {
        return fail(standing.diagnostics());
    }
    if (const auto complaint = refused(options, *pixel, **recording)) {
        return fail({*complaint});
    }
    const trace::Player& player = **standing;
    Answer answer{player, *pixel, explain::why_this_color(player, *pixel), {}};
    if (options.triangle) {
        answer.color.clear();
        answer.triangles = {explain::triangle_at_pixel(player, *pixel, *options.triangle)};
    } else {
        answer.triangles = explain::triangles_at_pixel(player, *pixel);
    }
    return print(common.json ? as_json(answer) : as_text(answer));
}

} // namespace

Command add_why(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app = program.add_subcommand(
        "why", "Say why a pixel has its color, and why other triangles do not show there"
    );
    app->footer("Examples:\n"
                "  halfspace why scene.toml --pixel 31,17\n"
                "  halfspace why scene.toml --pixel 31,17 --triangle 12");
    app->add_option("FILE", options->file, file_help)->required();
    app->add_option("--pixel", options->pixel, "X,Y, counted from the top left")->required();
    app->add_option("--at", options->at, at_help);
    app->add_option(
        "--triangle",
        options->triangle,
        "only this one, whether it could have colored the pixel or not; numbered over the frame"
    );
    return {app, [options, &common] { return run_why(*options, common); }, true};
}

} // namespace hs::command
