// `halfspace export`: any buffer or table of any step as a file.
#include "app/command/command.hpp"
#include "core/export/array_file.hpp"
#include "core/export/picture_file.hpp"
#include "core/export/table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hs::command {
namespace {

struct Options {
    std::filesystem::path file;
    std::string at;
    std::vector<std::string> what{"color"};
    std::filesystem::path out;
};

Diagnostic wrong_format(const Options& options, std::string_view known) {
    return {
        .file = options.out.string(),
        .message = fmt::format(
            "'{}' is not a format for this; known are {}", options.out.extension().string(), known
        )};
}

bool is_table(const std::string& name) {
    const auto layers = exporting::layer_names();
    return std::none_of(layers.begin(), layers.end(), [&](const exporting::LayerName& layer) {
        return layer.name == name;
    });
}

Result<Done> export_table(const trace::Player& player, const Options& options) {
    if (options.what.size() != 1) {
        return Diagnostic{
            .file = "--what", .message = "a table is exported alone; name one of them"};
    }
    const auto table = exporting::make_table(player.shared_recording(), options.what.front());
    if (!table) {
        return exporting::make_layers(player, options.what).diagnostics(); // names buffers, too
    }
    const std::string extension = options.out.extension().string();
    if (extension == ".csv") {
        return exporting::write_csv(options.out, *table);
    }
    if (extension == ".json") {
        return exporting::write_json(options.out, *table);
    }
    if (extension == ".npz") {
        return exporting::write_npz(options.out, *table);
    }
    return wrong_format(options, ".csv, .json and .npz");
}

/// What a file says about where it comes from.
exporting::Attributes attributes_of(const trace::Player& player) {
    exporting::Attributes attributes{
        {"halfspace:scene", player.recording().scene().name},
        {"halfspace:step", trace::step_path(player.current())},
        {"halfspace:step_number", fmt::format("#{}", player.step())}};
    for (const scene::SettingInfo& info : scene::setting_infos()) {
        attributes.emplace_back(
            fmt::format("halfspace:{}", info.key),
            scene::print_setting(player.recording().settings(), info.key)
        );
    }
    return attributes;
}

Result<Done> export_layers(const trace::Player& player, const Options& options) {
    const auto layers = exporting::make_layers(player, options.what);
    if (!layers) {
        return layers.diagnostics();
    }
    const std::string extension = options.out.extension().string();
    if (extension == ".exr") {
        return exporting::write_exr(options.out, *layers, attributes_of(player));
    }
    if (extension == ".npz") {
        return exporting::write_npz(options.out, *layers);
    }
    if (extension == ".csv") {
        return exporting::write_csv(options.out, *layers);
    }
    if (extension != ".png") {
        return wrong_format(options, ".png, .exr, .npz and .csv");
    }
    if (layers->size() != 1) {
        return Diagnostic{
            .file = options.out.string(),
            .message = "a PNG holds one buffer; write .exr or .npz for several"};
    }
    return exporting::write_png(options.out, layers->front(), attributes_of(player));
}

int run_export(const Options& options, const Common& common) {
    auto recording = record_input(options.file, common);
    if (!recording) {
        return fail(recording.diagnostics());
    }
    const auto player = stand_on(*recording, options.at);
    if (!player) {
        return fail(player.diagnostics());
    }
    const bool table = std::any_of(options.what.begin(), options.what.end(), is_table);
    const Result<Done> written =
        table ? export_table(**player, options) : export_layers(**player, options);
    return written ? status_done : fail(written.diagnostics());
}

} // namespace

Command add_export(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app = program.add_subcommand("export", "Write buffers or tables of any step");
    std::string buffers;
    for (const exporting::LayerName& layer : exporting::layer_names()) {
        buffers += fmt::format("\n  {}: {}", layer.name, layer.explanation);
    }
    app->footer(
        "Buffers, to .png (one), .exr, .npz or .csv:" + buffers +
        "\nTables, to .csv, .json or .npz: vertices, triangles, fragments, runs, counters, pieces, "
        "piece-vertices\n\nhalfspace export scene.toml --at 'object 0 / triangle 12 / fragment "
        "31,17 / depth test' --what depth -o depth.exr"
    );
    app->add_option("FILE", options->file, "scene, mesh or lesson")->required();
    app->add_option("--at", options->at, "step path or #number; default: the end");
    app->add_option("--what", options->what, "buffers, separated by commas, or one table")
        ->delimiter(',');
    app->add_option("-o,--output", options->out, "file to write; its ending chooses the format")
        ->required();
    return {app, [options, &common] { return run_export(*options, common); }};
}

} // namespace hs::command
