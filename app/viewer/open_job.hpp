// The work behind opening: loading and recording, run beside the window.
#pragma once

#include "app/viewer/background.hpp"
#include "app/viewer/state.hpp"
#include "core/scene/scene_file.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace hs::lesson {
struct LessonStep;
enum class View : std::uint8_t;
enum class Panel : std::uint8_t;
} // namespace hs::lesson

namespace hs::viewer {

Opened open_job(
    const std::filesystem::path& file,
    std::span<const scene::Assignment> assignments,
    const std::string& at,
    const Background::Progress& progress
);

Opened record_job(
    std::shared_ptr<const scene::Scene> scene,
    const std::string& at,
    const Background::Progress& progress
);

/// Records what goes beside `main`, and finds where it differs.
Opened beside_job(
    std::shared_ptr<const scene::Scene> scene,
    const trace::Recording& main,
    const Background::Progress& progress
);

/// Brings one view or one tab of the inspector to the front, as lessons name them.
void show_view(lesson::View view, State& state);
void show_panel(lesson::Panel panel, State& state);

/// Brings the views and panels a lesson's step asks for to the front.
void apply_lesson_views(const lesson::LessonStep& step, State& state);

} // namespace hs::viewer
