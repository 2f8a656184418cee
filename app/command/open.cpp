// `halfspace open`, and `halfspace` alone: the viewer in a window.
#include "app/command/command.hpp"
#include "app/host/glfw_window.hpp"
#include "app/lesson/library.hpp"
#include "app/viewer/viewer.hpp"

#include <system_error>

namespace hs::command {
namespace {

struct Options {
    std::filesystem::path file;
    std::string at;
    std::string beside;
};

/// What is wrong inside the file, the window lists in full; what is wrong with the command is said
/// before a window opens.
int open(const Options& options, const Common& common) {
    std::error_code error;
    if (!std::filesystem::exists(options.file, error)) {
        return fail({{.file = options.file.string(), .message = "there is no such file"}});
    }
    const Result<std::vector<scene::Assignment>> assignments = assignments_of(common);
    if (!assignments) {
        return fail(assignments.diagnostics());
    }
    viewer::Viewer viewer;
    if (const Result<Done> shown = show_beside(viewer, options.beside); !shown) {
        return fail(shown.diagnostics());
    }
    viewer.open(options.file, {.at = options.at, .assignments = *assignments});
    return host::run_in_window(viewer, {});
}

} // namespace

Command add_open(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app =
        program.add_subcommand("open", "Open a scene, a mesh or a lesson in the viewer");
    app->footer(
        "Example:\n  halfspace open bunny.obj --size 1920x1080 --at 'object 0 / triangle 12'"
    );
    app->add_option("FILE", options->file, file_help)->required();
    app->add_option("--at", options->at, at_help);
    app->add_option("--beside", options->beside, beside_help);
    return {app, [options, &common] { return open(*options, common); }};
}

int open_lessons(const Common& common) {
    const std::filesystem::path folder = lesson::lessons_folder();
    const auto lessons = lesson::find_lessons(folder);
    if (lessons.empty()) {
        return fail(
            {{.file = folder.string(),
              .message = "there are no lessons here; open a scene with 'halfspace open FILE'"}}
        );
    }
    return open({.file = lessons.front(), .at = {}, .beside = {}}, common);
}

} // namespace hs::command
