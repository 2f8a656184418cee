// `halfspace record`: a frame's facts into a file that NumPy opens.
#include "app/command/command.hpp"
#include "core/export/trace_file.hpp"
#include "core/export/whole_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hs::command {
namespace {

struct Options {
    std::filesystem::path file;
    std::filesystem::path out;
};

int report(const trace::Recording& recording, const Options& options, const Common& common) {
    if (common.json) {
        const nlohmann::ordered_json document{
            {"trace", options.out.string()},
            {"steps", recording.end_step + 1},
            {"triangles", recording.triangles.size()},
            {"fragments", recording.fragments.size()},
            {"bytes_in_memory", recording.bytes()}};
        return print(document.dump() + '\n');
    }
    if (common.quiet) {
        return status_done;
    }
    return print(fmt::format(
        "{}: {} steps, {} triangles, {} fragments\n",
        options.out.string(),
        recording.end_step + 1,
        recording.triangles.size(),
        recording.fragments.size()
    ));
}

int record_trace(const Options& options, const Common& common) {
    if (const auto format = output_format(options.out, {".npz"}); !format) {
        return fail(format.diagnostics());
    }
    if (const Result<Done> good = exporting::check_writable(options.out); !good) {
        return fail(good.diagnostics());
    }
    const Result<Source> source = find_source(options.file, common);
    if (!source) {
        return fail(source.diagnostics());
    }
    const auto recording = record(*source, common);
    if (!recording) {
        return fail(recording.diagnostics());
    }
    const Result<Done> saved = exporting::save_trace(*recording, options.out, source->assignments);
    return saved ? report(**recording, options, common) : fail(saved.diagnostics());
}

} // namespace

Command add_record(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app = program.add_subcommand("record", "Record a frame into a trace file");
    app->footer("numpy.load opens a trace. Example:\n"
                "  halfspace record scene.toml --set depth.test=always -o always.npz");
    app->add_option("FILE", options->file, file_help)->required();
    app->add_option("-o,--output", options->out, "trace to write: .npz")->required();
    return {app, [options, &common] { return record_trace(*options, common); }, true};
}

} // namespace hs::command
