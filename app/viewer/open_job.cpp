#include "app/viewer/open_job.hpp"

#include "app/lesson/lesson.hpp"
#include "app/lesson/library.hpp"
#include "app/lesson/session.hpp"
#include "core/base/check.hpp"

#include <utility>

namespace hs::viewer {
namespace {

Opened failed(Diagnostics problems) {
    Opened opened;
    opened.problems = std::move(problems);
    return opened;
}

Opened open_lesson(const std::filesystem::path& file) {
    Result<lesson::Lesson> loaded = lesson::load_lesson(file);
    if (!loaded) {
        return failed(loaded.diagnostics());
    }
    Opened opened;
    opened.session =
        std::make_shared<lesson::Session>(std::make_shared<const lesson::Lesson>(std::move(*loaded))
        );
    opened.file = file;
    return opened;
}

} // namespace

Opened record_job(
    std::shared_ptr<const scene::Scene> scene,
    const std::string& at,
    const Background::Progress& progress
) {
    trace::RecordOptions options;
    options.progress = progress;
    Result<std::shared_ptr<const trace::Recording>> recording =
        trace::record(std::move(scene), options);
    if (!recording) {
        return failed(recording.diagnostics());
    }
    Opened opened;
    opened.recording = std::move(*recording);
    opened.at = at;
    return opened;
}

Opened beside_job(
    std::shared_ptr<const scene::Scene> scene,
    const trace::Recording& main,
    const Background::Progress& progress
) {
    Opened opened = record_job(std::move(scene), "", progress);
    opened.beside = true;
    if (opened.recording != nullptr) {
        opened.difference = trace::difference(main, *opened.recording);
    }
    return opened;
}

Opened open_job(
    const std::filesystem::path& file,
    std::span<const scene::Assignment> assignments,
    const std::string& at,
    const Background::Progress& progress
) {
    if (lesson::is_lesson(file)) {
        return open_lesson(file);
    }
    Result<scene::Scene> loaded = scene::load_scene(file, assignments);
    if (!loaded) {
        return failed(loaded.diagnostics());
    }
    Opened opened =
        record_job(std::make_shared<const scene::Scene>(std::move(*loaded)), at, progress);
    opened.file = file;
    return opened;
}

void show_view(lesson::View view, State& state) {
    using lesson::View;
    if (view >= View::color && view <= View::barycentric) {
        const int offset = static_cast<int>(view) - static_cast<int>(View::color);
        state.screen.content = static_cast<ScreenContent>(offset);
    } else if (view >= View::object && view <= View::ndc) {
        const int offset = static_cast<int>(view) - static_cast<int>(View::object);
        show_space(state.space, static_cast<Space>(offset));
        state.side = SidePanel::space;
        state.show_side = true;
    } else if (view >= View::projection) {
        const int offset = static_cast<int>(view) - static_cast<int>(View::projection);
        state.side = static_cast<SidePanel>(static_cast<int>(SidePanel::projection) + offset);
        state.show_side = true;
    }
}

void show_panel(lesson::Panel panel, State& state) {
    using lesson::Panel;
    switch (panel) {
    case Panel::unchanged: return;
    case Panel::vertex:
    case Panel::matrices: state.tab = InspectorTab::vertex; return;
    case Panel::triangle: state.tab = InspectorTab::triangle; return;
    case Panel::fragment: state.tab = InspectorTab::fragment; return;
    case Panel::values: state.tab = InspectorTab::values; return;
    case Panel::history: state.tab = InspectorTab::history; return;
    case Panel::state: state.tab = InspectorTab::state; return;
    }
    HS_CHECK(false, "every panel a lesson names is handled");
}

void apply_lesson_views(const lesson::LessonStep& step, State& state) {
    show_view(step.view, state);
    show_panel(step.panel, state);
}

} // namespace hs::viewer
