// `halfspace export`: any buffer or table of any step as a file.
#include "app/command/command.hpp"
#include "core/export/layer_file.hpp"
#include "core/export/picture_file.hpp"
#include "core/export/table_file.hpp"
#include "core/export/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hs::command {
namespace {

struct Options {
    std::filesystem::path file;
    std::string at;
    std::string names = "color";     ///< as written, separated by commas
    std::vector<std::string> what{}; ///< the same, taken apart
    std::filesystem::path out;
};

template <typename Names>
bool is_among(const Names& names, const std::string& name) {
    return std::any_of(names.begin(), names.end(), [&name](const auto& row) {
        return row.name == name;
    });
}

Diagnostic bad_what(std::string message) {
    return {.file = "--what", .message = std::move(message)};
}

Diagnostic unknown_what(const std::string& name) {
    std::string buffers;
    std::string tables;
    for (const exporting::LayerName& layer : exporting::layer_names()) {
        buffers += fmt::format("{}{}", buffers.empty() ? "" : ", ", layer.name);
    }
    for (const exporting::TableName& table : exporting::table_names()) {
        tables += fmt::format("{}{}", tables.empty() ? "" : ", ", table.name);
    }
    return bad_what(
        fmt::format("'{}' is neither a buffer ({}) nor a table ({})", name, buffers, tables)
    );
}

/// Everything that can be refused before the frame is recorded.
Result<Done> check_options(const Options& options) {
    const bool table = is_among(exporting::table_names(), options.what.front());
    for (const std::string& name : options.what) {
        if (!is_among(exporting::layer_names(), name) &&
            !is_among(exporting::table_names(), name)) {
            return unknown_what(name);
        }
        if (options.what.size() > 1 && is_among(exporting::table_names(), name)) {
            return bad_what(fmt::format("'{}' is a table, which is exported alone", name));
        }
    }
    const Result<std::string> format =
        table ? output_format(options.out, {".csv", ".json", ".npz"})
              : output_format(options.out, {".png", ".exr", ".npz", ".csv"});
    if (!format) {
        return format.diagnostics();
    }
    if (*format == ".png" && options.what.size() > 1) {
        return Diagnostic{
            .file = options.out.string(),
            .message = "a PNG holds one buffer; write .exr, .npz or .csv for several"};
    }
    return exporting::check_writable(options.out);
}

Result<Done> write_table(const trace::Player& player, const Options& options) {
    const Result<exporting::Table> table = exporting::make_table(player, options.what.front());
    if (!table) {
        return table.diagnostics();
    }
    if (options.out.extension() == ".csv") {
        return exporting::write_csv(options.out, *table);
    }
    if (options.out.extension() == ".json") {
        return exporting::write_json(options.out, *table);
    }
    return exporting::write_npz(options.out, *table, exporting::attributes_of(player));
}

Result<Done> write_layers(const trace::Player& player, const Options& options) {
    const auto layers = exporting::make_layers(player, options.what);
    if (!layers) {
        Diagnostics diagnostics = layers.diagnostics();
        diagnostics.front().file = "--what";
        return diagnostics;
    }
    const exporting::Attributes attributes = exporting::attributes_of(player);
    if (options.out.extension() == ".exr") {
        return exporting::write_exr(options.out, *layers, attributes);
    }
    if (options.out.extension() == ".npz") {
        return exporting::write_npz(options.out, *layers, attributes);
    }
    if (options.out.extension() == ".csv") {
        return exporting::write_csv(options.out, *layers);
    }
    return exporting::write_png(options.out, layers->front(), attributes);
}

std::vector<std::string> split(std::string_view text) {
    std::vector<std::string> parts;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        parts.emplace_back(text.substr(from, comma - from));
        from = comma + 1;
    }
    return parts;
}

int run_export(Options options, const Common& common) {
    options.what = split(options.names);
    if (const Result<Done> good = check_options(options); !good) {
        return fail(good.diagnostics());
    }
    const auto recording = record_file(options.file, common);
    if (!recording) {
        return fail(recording.diagnostics());
    }
    const auto player = stand_on(*recording, options.at);
    if (!player) {
        return fail(player.diagnostics());
    }
    const bool table = is_among(exporting::table_names(), options.what.front());
    const Result<Done> written =
        table ? write_table(**player, options) : write_layers(**player, options);
    return written ? status_done : fail(written.diagnostics());
}

std::string footer() {
    std::string text = "Buffers, to .png (one of them), .exr, .npz or .csv:\n";
    for (const exporting::LayerName& layer : exporting::layer_names()) {
        text += fmt::format("  {:<16}{}\n", layer.name, layer.explanation);
    }
    text += "Tables, one at a time, to .csv, .json or .npz:\n";
    for (const exporting::TableName& table : exporting::table_names()) {
        text += fmt::format("  {:<16}{}\n", table.name, table.explanation);
    }
    return text +
           "\nExamples:\n"
           "  halfspace export scene.toml --what color,depth,triangle -o frame.exr\n"
           "  halfspace export scene.toml --at 'object 0 / triangle 12 / fragment 31,17 / depth "
           "test' --what depth -o depth.exr\n"
           "  halfspace export bunny.obj --what triangles -o triangles.csv";
}

} // namespace

Command add_export(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app = program.add_subcommand("export", "Write buffers or a table of any step");
    app->footer(footer());
    app->add_option("FILE", options->file, file_help)->required();
    app->add_option("--at", options->at, at_help);
    app->add_option("--what", options->names, "buffers, separated by commas, or a table")
        ->capture_default_str();
    app->add_option("-o,--output", options->out, "file to write; its ending chooses the format")
        ->required();
    return {app, [options, &common] { return run_export(*options, common); }, true};
}

} // namespace hs::command
