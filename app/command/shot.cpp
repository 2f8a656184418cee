// `halfspace shot`: a picture of the viewer itself, no display needed.
#include "app/command/command.hpp"
#include "app/command/interrupt.hpp"
#include "app/host/headless.hpp"
#include "app/lesson/lesson.hpp"
#include "app/lesson/library.hpp"
#include "app/lesson/session.hpp"
#include "app/viewer/open_job.hpp"
#include "app/viewer/viewer.hpp"
#include "core/base/spelling.hpp"
#include "core/export/picture_file.hpp"
#include "core/export/whole_file.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace hs::command {
namespace {

struct Options {
    std::filesystem::path file;
    std::string at;
    bool all = false;
    std::vector<std::string> views;
    std::string panel = "unchanged";
    std::string beside;
    std::optional<float> morph;
    bool side = false;
    bool light = false;
    bool large = false;
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

/// A name of an enumeration; what else there is where it is none.
template <typename Enum>
Result<Enum> read_name(std::string_view option, const std::string& text) {
    if (const std::optional<Enum> value = parse_name<Enum>(text)) {
        return *value;
    }
    std::vector<std::string_view> known;
    for (const Named<Enum>& row : names<Enum>()) {
        known.push_back(row.name);
    }
    return Diagnostic{
        .file = std::string{option},
        .message = fmt::format("\"{}\" is not one of {}", text, list_of_choices(known))};
}

/// What the window is to show, in the words that lessons use.
Result<Done> arrange(viewer::State& state, const Options& options) {
    for (const std::string& name : options.views) {
        const Result<lesson::View> view = read_name<lesson::View>("--view", name);
        if (!view) {
            return view.diagnostics();
        }
        viewer::show_view(*view, state);
    }
    const Result<lesson::Panel> panel = read_name<lesson::Panel>("--panel", options.panel);
    if (!panel) {
        return panel.diagnostics();
    }
    viewer::show_panel(*panel, state);
    if (options.morph) {
        viewer::set_morph(state.space, *options.morph);
    }
    state.space.side = options.side;
    return done;
}

/// How the window looks, whatever it shows.
void dress(viewer::State& state, const Options& options) {
    state.theme = options.light ? viewer::ThemeKind::light : viewer::ThemeKind::dark;
    state.presentation = options.large ? viewer::presentation_factor : 1.0F;
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
    if (Result<Done> shown = show_beside(viewer, options.beside); !shown) {
        return shown;
    }
    if (const auto complaint = options.at.empty() ? std::nullopt : viewer.go_to(options.at)) {
        return Diagnostic{.file = "--at", .message = *complaint};
    }
    host.settle(viewer); // the inspector has come along; what is asked for comes after it
    if (const std::string& complaint = viewer.beside().complaint(); !complaint.empty()) {
        return Diagnostic{.file = "--beside", .message = complaint};
    }
    if (Result<Done> arranged = arrange(viewer.state(), options); !arranged) {
        return arranged;
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
    dress(viewer.state(), options);
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
    app->add_option(
        "--view", options->views, "what a lesson's view names: depth, ndc, clipping …; repeatable"
    );
    app->add_option("--panel", options->panel, "the inspector's tab, as in lessons");
    app->add_option("--beside", options->beside, beside_help);
    app->add_option("--morph", options->morph, "space view between 0 (eye), 1 (clip) and 2 (NDC)");
    app->add_flag("--side", options->side, "space view seen from the side");
    app->add_flag("--light", options->light, "light colors, for print and projectors");
    app->add_flag("--large", options->large, "large type for the lecture hall");
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
