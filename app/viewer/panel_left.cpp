// The left column: the lesson, or what the scene is made of and its settings.
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"

#include <array>

namespace hs::viewer {

void draw_left(Context& context, const Rect& rect) {
    const Theme& theme = context.theme;
    begin_panel("left", rect, theme, false);
    const bool no_lesson = context.viewer.session() == nullptr;
    const std::array tabs{
        Segment{
            "lesson",
            "what the lesson says and asks",
            no_lesson ? "No lesson is open: choose one from the menu Lessons." : ""},
        Segment{"scene", "objects, camera and settings", ""},
    };
    const int clicked = segments(theme, "left tabs", tabs, static_cast<int>(context.state.left));
    if (clicked >= 0) {
        context.state.left = static_cast<LeftTab>(clicked);
    }
    const float top = ImGui::GetCursorScreenPos().y;
    const float pad = theme.units(3);
    begin_panel("left content", {rect.x, top, rect.width, rect.bottom() - top}, theme, true);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + rect.width - 2.0F * pad);
    if (context.state.left == LeftTab::lesson && !no_lesson) {
        draw_lesson(context);
    } else {
        draw_scene(context);
    }
    ImGui::PopTextWrapPos();
    end_panel();
    end_panel();
}

} // namespace hs::viewer
