// One sentence about the current step, always in sight.
#include "app/viewer/lesson_hiding.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"

#include <cmath>
#include <string>

namespace hs::viewer {

namespace {

/// In one line, else in two smaller ones; false when even those cannot hold it.
bool draw_fitted(const Theme& theme, const std::string& text, const Rect& rect) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImFont* font = theme.fonts.text;
    if (text_size(font, text).x <= rect.width) {
        const float y = rect.y + (rect.height - font->FontSize) * 0.5F;
        draw_text(list, font, {rect.x, y}, theme[Tone::text], text);
        return true;
    }
    ImFont* small = theme.fonts.small;
    const ImVec2 size = small->CalcTextSizeA(small->FontSize, rect.width, rect.width, text.c_str());
    const bool fits = size.y <= rect.height;
    const std::string shown = fits ? text : shorten(small, text, rect.width);
    const float height = fits ? size.y : small->FontSize;
    list.AddText(
        small,
        small->FontSize,
        {rect.x, std::floor(rect.y + (rect.height - height) * 0.5F)},
        theme[Tone::text],
        shown.c_str(),
        nullptr,
        rect.width
    );
    return fits;
}

} // namespace

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
    const float x = rect.x + theme.units(3);
    const float room = rect.right() - x - theme.units(3);
    const bool whole = draw_fitted(theme, text, {x, rect.y, room, rect.height});
    ImGui::SetCursorScreenPos({rect.x, rect.y});
    ImGui::InvisibleButton("whole sentence", {rect.width, rect.height});
    if (!whole) {
        tooltip(text);
    }
    if (notice && ImGui::IsItemClicked()) {
        context.state.notice.clear();
    }
    end_panel();
}

} // namespace hs::viewer
