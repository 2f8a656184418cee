// The screen view: the framebuffer after the current step, from the whole image to numbers on
// pixels.
#include "app/viewer/panels.hpp"
#include "app/viewer/screen_overlay.hpp"
#include "app/viewer/screen_view.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"

#include <algorithm>
#include <vector>

namespace hs::viewer {
namespace {

void draw_toolbar(Context& context) {
    std::vector<Segment> list;
    const bool no_triangle = context.document.piece_detail() == nullptr;
    for (const Named<ScreenContent>& row : names<ScreenContent>()) {
        const bool missing = is_of_triangle(row.value) && no_triangle;
        list.push_back(
            {row.name,
             row.explanation,
             missing ? "The playhead stands in no triangle: step into one first." : ""}
        );
    }
    const int chosen = static_cast<int>(context.state.screen.content);
    const int clicked = segments(context.theme, "views", list, chosen);
    if (clicked >= 0) {
        context.state.screen.content = static_cast<ScreenContent>(clicked);
    }
}

} // namespace

void draw_screen(Context& context, const Rect& rect, ScreenPicture& picture) {
    const Theme& theme = context.theme;
    begin_panel("screen", rect, theme, false);
    if (!context.document.is_open()) {
        heading(theme, "Screen");
        empty_note(
            theme,
            "Here you will see the picture grow, pixel by pixel. Open a scene, a mesh or a "
            "lesson with Ctrl+O, or drop its file on this window."
        );
        end_panel();
        return;
    }
    draw_toolbar(context);

    // The picture takes what legend and readout leave
    ScreenView& view = context.state.screen;
    const float footer = theme.units(12);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float pad = theme.units(3);
    const float bottom = rect.bottom() - footer;
    view.area = {
        rect.x + pad, corner.y, rect.width - 2.0F * pad, std::max(8.0F, bottom - corner.y)};
    ImVec2 room{view.area.width, view.area.height};
    const BesideView& beside = context.state.beside;
    const bool twice = context.viewer.shows_beside();
    if (twice) { // both pictures are equally large
        room = {std::min(room.x, beside.area.width), std::min(room.y, beside.area.height)};
    }
    if (!twice || !beside.area.contains(ImGui::GetIO().MousePos)) {
        context.state.hovered.reset();
    }
    draw_screen_view(context, room, picture);
    draw_legend(
        context, picture, {view.area.x, bottom + theme.units(1), view.area.width, theme.units(5)}
    );
    draw_readout(context, {view.area.x, bottom + theme.units(6), view.area.width, theme.units(5)});
    end_panel();
}

} // namespace hs::viewer
