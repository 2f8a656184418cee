// The side panel: one of several views of the same step, beside the screen.
#include "app/viewer/lesson_hiding.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"

#include <vector>

namespace hs::viewer {
namespace {

void draw_content(Context& context, const Rect& rect, SpaceLines& lines) {
    const Theme& theme = context.theme;
    const SidePanel panel = context.state.side;
    if (panel == SidePanel::space) {
        draw_space(context, rect, lines);
        return;
    }
    if (panel == SidePanel::beside) {
        draw_beside(context, rect);
        return;
    }
    begin_panel("side content", rect, theme, true);
    if (hides_numbers(context.viewer)) {
        empty_note(theme, hidden_note);
    } else if (panel == SidePanel::projection) {
        draw_projection(context);
    } else if (panel == SidePanel::precision) {
        draw_precision(context);
    } else if (panel == SidePanel::clipping) {
        draw_clipping(context);
    } else if (panel == SidePanel::search) {
        draw_search(context);
    } else if (panel == SidePanel::cost) {
        draw_cost(context);
    } else if (panel == SidePanel::registers) {
        draw_registers(context);
    } else if (panel == SidePanel::normals) {
        draw_normals(context);
    } else {
        draw_order(context);
    }
    end_panel();
}

} // namespace

void draw_side(Context& context, const Rect& rect, SpaceLines& lines) {
    const Theme& theme = context.theme;
    begin_panel("side", rect, theme, false);
    std::vector<Segment> tabs;
    for (const Named<SidePanel>& row : names<SidePanel>()) {
        tabs.push_back({row.name, row.explanation, ""});
    }
    const int clicked = segments(theme, "side panels", tabs, static_cast<int>(context.state.side));
    if (clicked >= 0) {
        context.state.side = static_cast<SidePanel>(clicked);
    }
    if (!context.document.is_open()) {
        empty_note(
            theme,
            "Here you will see the meshes in every coordinate space, with the view volume, and "
            "what projection, depth, clipping, traversals and ordering do to them."
        );
    } else {
        const float top = ImGui::GetCursorScreenPos().y;
        draw_content(context, {rect.x, top, rect.width, rect.bottom() - top}, lines);
    }
    end_panel();
}

} // namespace hs::viewer
