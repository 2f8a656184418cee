// `halfspace shot`: a picture of the viewer itself, no display needed.
#include "app/command/command.hpp"
#include "app/command/interrupt.hpp"
#include "app/host/headless.hpp"
#include "app/lesson/lesson.hpp"
#include "app/lesson/library.hpp"
#include "app/lesson/session.hpp"
#include "app/viewer/viewer.hpp"
#include "core/export/picture_file.hpp"
#include "core/export/whole_file.hpp"

#include <fmt/format.h>

#include <system_error>

namespace hs::command {
namespace {

struct Options {
    std::filesystem::path file;
    std::string at;
    bool all = false;
    std::filesystem::path out;
};

/// --size is the window's; the usual one is the smallest in which nothing may be clipped.
Result<Size> window_size(const Common& common) {
    return common.size.empty() ? Size{1280, 720} : parse_size(common.size);
}

/// Opens as the window does, but what is wrong is a result.
Result<Done> open_in(
    viewer::Viewer& viewer, const std::filesystem::path& file, viewer::OpenOptions options = {}
) {
    viewer.open(file, options);
    viewer.finish_background_work();
    if (!viewer.state().problems.empty()) {
        return viewer.state().problems;
    }
    return done;
}

Result<Done> shoot(
    host::HeadlessHost& host,
    viewer::Viewer& viewer,
    const std::filesystem::path& out,
    const exporting::Attributes& attributes
) {
    host.settle(viewer);
    const host::Picture picture = host.picture();
    return exporting::write_png(out, picture.width, picture.height, picture.pixels, attributes);
}

/// One picture per step of the lesson: step-01.png, step-02.png …
Result<Done>
shoot_lesson(host::HeadlessHost& host, viewer::Viewer& viewer, const Options& options) {
    if (!lesson::is_lesson(options.file)) {
        return Diagnostic{.file = options.file.string(), .message = "--all needs a lesson"};
    }
    if (Result<Done> opened = open_in(viewer, options.file); !opened) {
        return opened;
    }
    std::error_code error;
    std::filesystem::create_directories(options.out, error);
    if (error) {
        return Diagnostic{
            .file = options.out.string(),
            .message = fmt::format("cannot be made: {}", error.message())};
    }
    const std::size_t steps = viewer.session()->lesson().steps.size();
    for (std::size_t step = 0; step < steps && !stop_requested(); ++step) {
        viewer.go_to_lesson_step(step);
        if (const Diagnostics& problems = viewer.session()->problems(); !problems.empty()) {
            return problems;
        }
        const std::filesystem::path out = options.out / fmt::format("step-{:02}.png", step + 1);
        if (Result<Done> written = shoot(host, viewer, out, {}); !written) {
            return written;
        }
    }
    return done;
}

Result<Done> shoot_step(
    host::HeadlessHost& host, viewer::Viewer& viewer, const Options& options, const Common& common
) {
    // A changed scene is no longer the lesson's
    Source source{.file = options.file, .assignments = {}};
    if (!common.set.empty()) {
        Common without_size = common;
        without_size.size.clear();
        Result<Source> changed = find_source(options.file, without_size);
        if (!changed) {
            return changed.diagnostics();
        }
        source = std::move(*changed);
    }
    if (Result<Done> opened =
            open_in(viewer, source.file, {.at = {}, .assignments = source.assignments});
        !opened) {
        return opened;
    }
    if (const auto complaint = options.at.empty() ? std::nullopt : viewer.go_to(options.at)) {
        return Diagnostic{.file = "--at", .message = *complaint};
    }
    const exporting::Attributes attributes =
        viewer.document().is_open() ? exporting::attributes_of(viewer.document().player())
                                    : exporting::Attributes{};
    return shoot(host, viewer, options.out, attributes);
}

int run_shot(const Options& options, const Common& common) {
    const Result<Size> size = window_size(common);
    if (!size) {
        return fail(size.diagnostics());
    }
    if (!options.all) {
        if (const auto format = output_format(options.out, {".png"}); !format) {
            return fail(format.diagnostics());
        }
        if (const Result<Done> good = exporting::check_writable(options.out); !good) {
            return fail(good.diagnostics());
        }
    }
    host::HeadlessHost host(size->width, size->height);
    viewer::Viewer viewer;
    const Result<Done> taken = options.all ? shoot_lesson(host, viewer, options)
                                           : shoot_step(host, viewer, options, common);
    return taken ? status_done : fail(taken.diagnostics());
}

} // namespace

Command add_shot(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app =
        program.add_subcommand("shot", "Draw a picture of the viewer itself, without a display");
    app->footer("--size is the size of the window here; an image's is set by --set size=[W,H].\n"
                "Examples:\n"
                "  halfspace shot scene.toml --at 'object 0 / triangle 12' -o triangle.png\n"
                "  halfspace shot lessons/01-one-triangle --all -o pictures");
    app->add_option("FILE", options->file, file_help)->required();
    app->add_option("--at", options->at, at_help);
    app->add_flag("--all", options->all, "a picture of every step of a lesson, into a folder");
    app->add_option(
           "-o,--output",
           options->out,
           "picture to write (.png); with --all a folder for step-01.png …"
    )
        ->required();
    return {app, [options, &common] { return run_shot(*options, common); }, true};
}

} // namespace hs::command
