// `halfspace record`: a frame's facts into a file that NumPy opens.
#include "app/command/command.hpp"
#include "core/export/trace_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hs::command {
namespace {

struct Options {
    std::filesystem::path file;
    std::filesystem::path out;
};

void report(const trace::Recording& recording, const Options& options, const Common& common) {
    if (common.json) {
        const nlohmann::ordered_json document{
            {"trace", options.out.string()},
            {"steps", recording.end_step + 1},
            {"triangles", recording.triangles.size()},
            {"fragments", recording.fragments.size()},
            {"bytes_in_memory", recording.bytes()}};
        fmt::print("{}\n", document.dump());
    } else if (!common.quiet) {
        fmt::print(
            "{}: {} steps, {} triangles, {} fragments\n",
            options.out.string(),
            recording.end_step + 1,
            recording.triangles.size(),
            recording.fragments.size()
        );
    }
}

int record(const Options& options, const Common& common) {
    if (options.out.extension() != ".npz") {
        return fail({{.file = options.out.string(), .message = "a trace's name ends in .npz"}});
    }
    const auto recording = record_input(options.file, common);
    if (!recording) {
        return fail(recording.diagnostics());
    }
    const Result<Done> saved = exporting::save_trace(*recording, options.out);
    if (!saved) {
        return fail(saved.diagnostics());
    }
    report(**recording, options, common);
    return status_done;
}

} // namespace

Command add_record(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app = program.add_subcommand("record", "Record a frame into a trace file");
    app->add_option("FILE", options->file, "scene, mesh or lesson")->required();
    app->add_option("-o,--output", options->out, "trace to write: .npz")->required();
    return {app, [options, &common] { return record(*options, common); }};
}

} // namespace hs::command
