// One sentence about the current step, always in sight.
#include "app/viewer/lesson_hiding.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"

namespace hs::viewer {

void draw_sentence(Context& context, const Rect& rect) {
    const Theme& theme = context.theme;
    begin_panel("sentence", rect, theme, false);
    const bool open = context.document.is_open();
    std::string text = open
                           ? context.document.sentence()
                           : "Open a scene, a mesh or a lesson with Ctrl+O, or drop its file here. "
                             "Press ? for all keys.";
    if (open && hides_numbers(context.viewer)) {
        text = trace::step_path(context.document.player().current()) +
               ": its numbers appear when the lesson's question is answered.";
    }
    const bool notice = !context.state.notice.empty();
    if (notice) {
        text = context.state.notice + "  " + text;
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float bar = theme.units(1);
    if (open) {
        const trace::Stage stage = trace::stage_of(context.document.player().current().kind);
        list.AddRectFilled({rect.x, rect.y}, {rect.x + bar, rect.bottom()}, theme.stage(stage));
    }
    ImFont* font = theme.fonts.text;
    const float x = rect.x + theme.units(3);
    const std::string shown = shorten(font, text, rect.right() - x - theme.units(3));
    draw_text(
        list, font, {x, rect.y + (rect.height - font->FontSize) * 0.5F}, theme[Tone::text], shown
    );
    ImGui::SetCursorScreenPos({rect.x, rect.y});
    ImGui::InvisibleButton("whole sentence", {rect.width, rect.height});
    if (shown != text) {
        tooltip(text);
    }
    if (notice && ImGui::IsItemClicked()) {
        context.state.notice.clear();
    }
    end_panel();
}

} // namespace hs::viewer
