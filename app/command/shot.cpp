// `halfspace shot`: a picture of the viewer itself, no display needed.
#include "app/command/command.hpp"
#include "app/host/headless.hpp"
#include "app/lesson/lesson.hpp"
#include "app/lesson/library.hpp"
#include "app/lesson/session.hpp"
#include "app/viewer/viewer.hpp"
#include "core/export/picture_file.hpp"

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

constexpr Size usual_size{1280, 720};

Result<Done> write_picture(const host::HeadlessHost& host, const std::filesystem::path& path) {
    const host::Picture picture = host.picture();
    return exporting::write_png(path, picture.width, picture.height, picture.pixels, {});
}

/// One picture per step of the lesson: step-01.png, step-02.png …
int shoot_lesson(const Options& options, const Size& size) {
    const Result<lesson::Lesson> opened = lesson::load_lesson(options.file);
    if (!opened) {
        return fail(opened.diagnostics());
    }
    std::error_code error;
    std::filesystem::create_directories(options.out, error);
    if (error) {
        return fail(
            {{.file = options.out.string(),
              .message = fmt::format("cannot be made: {}", error.message())}}
        );
    }
    host::HeadlessHost host(size.width, size.height);
    viewer::Viewer viewer;
    viewer.open(options.file);
    host.settle(viewer);
    for (std::size_t step = 0; step < opened->steps.size(); ++step) {
        viewer.go_to_lesson_step(step);
        host.settle(viewer);
        const Result<Done> written =
            write_picture(host, options.out / fmt::format("step-{:02}.png", step + 1));
        if (!written) {
            return fail(written.diagnostics());
        }
    }
    return status_done;
}

int shoot_step(const Options& options, const Common& common, const Size& size) {
    if (options.out.extension() != ".png") {
        return fail({{.file = options.out.string(), .message = "shot writes .png"}});
    }
    host::HeadlessHost host(size.width, size.height);
    viewer::Viewer viewer;
    if (lesson::is_lesson(options.file) && options.at.empty() && common.set.empty()) {
        const Result<lesson::Lesson> opened = lesson::load_lesson(options.file);
        if (!opened) {
            return fail(opened.diagnostics());
        }
        viewer.open(options.file);
    } else {
        const auto recording = record_input(options.file, common, false);
        if (!recording) {
            return fail(recording.diagnostics());
        }
        const auto player = stand_on(*recording, options.at);
        if (!player) {
            return fail(player.diagnostics());
        }
        viewer.set_recording(*recording);
        viewer.seek((*player)->step());
    }
    host.settle(viewer);
    const Result<Done> written = write_picture(host, options.out);
    return written ? status_done : fail(written.diagnostics());
}

int shoot(const Options& options, const Common& common) {
    Size size = usual_size;
    if (!common.size.empty()) {
        const Result<Size> given = parse_size(common.size);
        if (!given) {
            return fail(given.diagnostics());
        }
        size = *given;
    }
    if (!options.all) {
        return shoot_step(options, common, size);
    }
    if (!lesson::is_lesson(options.file)) {
        return fail({{.file = options.file.string(), .message = "--all needs a lesson"}});
    }
    return shoot_lesson(options, size);
}

} // namespace

Command add_shot(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app =
        program.add_subcommand("shot", "Draw a picture of the viewer itself, without a display");
    app->footer("--size is the size of the window here; set an image's with --set size=[W,H].");
    app->add_option("FILE", options->file, "scene, mesh or lesson")->required();
    app->add_option("--at", options->at, "step path or #number; default: the end");
    app->add_flag("--all", options->all, "a picture of every step of a lesson, into a folder");
    app->add_option("-o,--output", options->out, "picture to write (.png); with --all a folder")
        ->required();
    return {app, [options, &common] { return shoot(*options, common); }};
}

} // namespace hs::command
