// Below a pixel's history: why it has its color, and why other triangles do not show there.
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"

#include <fmt/format.h>

namespace hs::viewer {
namespace {

/// A line that leads to a step.
bool link(const Theme& theme, const std::string& text, const std::string& tip) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImFont* const font = theme.fonts.small;
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, width, width, text.c_str());
    const bool clicked = ImGui::Selectable("##link", false, 0, {0.0F, size.y});
    ImGui::GetWindowDrawList()->AddText(
        font, font->FontSize, at, theme[Tone::text], text.c_str(), nullptr, width
    );
    tooltip(tip + "\nclick goes there");
    return clicked;
}

void draw_color_links(Context& context, const std::vector<explain::ColorLink>& links) {
    heading(context.theme, "Why this color");
    int index = 0;
    for (const explain::ColorLink& each : links) {
        ImGui::PushID(index++);
        const explain::Expression& expression = *each.value.expression;
        const std::string text = fmt::format(
            "{} = {} = {}",
            each.value.name,
            explain::in_symbols(expression),
            explain::value_text(expression)
        );
        if (link(context.theme, text, each.path)) {
            context.viewer.follow({each.path, each.value.name, {}});
        }
        ImGui::PopID();
    }
}

void draw_reasons(Context& context, const std::vector<explain::TriangleAtPixel>& reasons) {
    heading(context.theme, "Why, or why not, each triangle");
    int index = 0;
    for (const explain::TriangleAtPixel& each : reasons) {
        ImGui::PushID(1000 + index++);
        const trace::Step step = trace::describe_step(context.document.recording(), each.step);
        if (link(context.theme, each.sentence, trace::step_path(step))) {
            context.viewer.seek(each.step);
        }
        ImGui::PopID();
    }
    if (reasons.empty()) {
        caption(context.theme, "No triangle's projection holds the pixel's center.");
    }
}

} // namespace

void draw_why(Context& context, PixelPos pixel) {
    const char* const tip =
        "the way back from its color, and what became of every triangle here; W";
    if (button(context.theme, "Why?", tip, "", context.state.show_why)) {
        context.state.show_why = !context.state.show_why;
    }
    if (!context.state.show_why) {
        return;
    }
    const Reasons& reasons = context.document.reasons(pixel);
    draw_color_links(context, reasons.color);
    draw_reasons(context, reasons.triangles);
}

} // namespace hs::viewer
