// `halfspace open`, and `halfspace` alone: the viewer in a window.
#include "app/command/command.hpp"
#include "app/host/glfw_window.hpp"
#include "app/lesson/library.hpp"
#include "app/viewer/viewer.hpp"
#include "core/scene/scene_file.hpp"

#include <fmt/format.h>

#include <system_error>

namespace hs::command {
namespace {

struct Options {
    std::filesystem::path file;
    std::string at;
};

/// What can be said before a window opens: the file's existence and the form of the assignments.
Result<viewer::OpenOptions> open_options(const Options& options, const Common& common) {
    std::error_code error;
    if (!std::filesystem::exists(options.file, error)) {
        return Diagnostic{.file = options.file.string(), .message = "there is no such file"};
    }
    viewer::OpenOptions result{.at = options.at, .assignments = {}};
    for (const std::string& text : common.set) {
        Result<scene::Assignment> assignment = scene::parse_assignment(text);
        if (!assignment) {
            return assignment.diagnostics();
        }
        result.assignments.push_back(std::move(*assignment));
    }
    if (!common.size.empty()) {
        const Result<Size> size = parse_size(common.size);
        if (!size) {
            return size.diagnostics();
        }
        result.assignments.push_back({"size", fmt::format("[{}, {}]", size->width, size->height)});
    }
    return result;
}

int open(const Options& options, const Common& common) {
    const Result<viewer::OpenOptions> given = open_options(options, common);
    if (!given) {
        return fail(given.diagnostics());
    }
    viewer::Viewer viewer;
    viewer.open(options.file, *given);
    return host::run_in_window(viewer, {});
}

} // namespace

Command add_open(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app =
        program.add_subcommand("open", "Open a scene, a mesh or a lesson in the viewer");
    app->add_option("FILE", options->file, "scene, mesh or lesson")->required();
    app->add_option("--at", options->at, "step path or #number; default: the end");
    return {app, [options, &common] { return open(*options, common); }};
}

int open_lessons(const Common& common) {
    const auto lessons = lesson::find_lessons(lesson::lessons_folder());
    if (lessons.empty()) {
        return fail(
            {{.file = lesson::lessons_folder().string(),
              .message = "there are no lessons here; open a scene with 'halfspace open FILE'"}}
        );
    }
    return open({.file = lessons.front(), .at = {}}, common);
}

} // namespace hs::command
