// The inspector: every number of the current step with the formula it came from.
#include "app/viewer/formula_view.hpp"
#include "app/viewer/lesson_hiding.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"

#include <vector>

namespace hs::viewer {

namespace {

bool shows_answers(InspectorTab tab) {
    return tab != InspectorTab::vertex && tab != InspectorTab::state;
}

} // namespace

void draw_inspector(Context& context, const Rect& rect) {
    const Theme& theme = context.theme;
    begin_panel("inspector", rect, theme, false);
    std::vector<Segment> tabs;
    for (const Named<InspectorTab>& row : names<InspectorTab>()) {
        tabs.push_back({row.name, row.explanation, ""});
    }
    const int clicked =
        segments(theme, "inspector tabs", tabs, static_cast<int>(context.state.tab));
    if (clicked >= 0) {
        context.state.tab = static_cast<InspectorTab>(clicked);
    }
    const float top = ImGui::GetCursorScreenPos().y;
    begin_panel("inspector content", {rect.x, top, rect.width, rect.bottom() - top}, theme, true);
    if (!context.document.is_open()) {
        empty_note(
            theme,
            "The numbers behind every step will stand here: matrices, clip distances, edge "
            "functions, weights, tests."
        );
    } else if (hides_beyond_vertex(context.viewer) && shows_answers(context.state.tab)) {
        empty_note(theme, hidden_note);
    } else {
        switch (context.state.tab) {
        case InspectorTab::vertex: draw_vertex_tab(context); break;
        case InspectorTab::triangle: draw_triangle_tab(context); break;
        case InspectorTab::fragment: draw_fragment_tab(context); break;
        case InspectorTab::values: draw_values_tab(context); break;
        case InspectorTab::history: draw_history_tab(context); break;
        case InspectorTab::state: draw_state_tab(context); break;
        }
    }
    end_panel();
    end_panel();
}

} // namespace hs::viewer
