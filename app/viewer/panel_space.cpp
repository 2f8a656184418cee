// The space view: the same vertices in object, world, eye, clip and normalized device coordinates,
// seen by a second camera from outside; and the pyramid of view on its way to becoming a box.
#include "app/viewer/panels.hpp"
#include "app/viewer/space_drawing.hpp"
#include "app/viewer/space_lines.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hs::viewer {
namespace {

constexpr float click_seconds = 0.2F; ///< for the whole way, after a click on a space

void draw_toolbar(Context& context) {
    SpaceView& view = context.state.space;
    std::vector<Segment> list;
    for (const Named<Space>& row : names<Space>()) {
        list.push_back({row.name, row.explanation, ""});
    }
    const int clicked = segments(context.theme, "spaces", list, static_cast<int>(view.space));
    if (clicked >= 0) {
        show_space(view, static_cast<Space>(clicked), click_seconds);
    }
}

/// From the pyramid of view to the box, as slowly as the hand moves.
void draw_morph_slider(Context& context) {
    SpaceView& view = context.state.space;
    const Theme& theme = context.theme;
    constexpr float last = 2.0F;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float button_width =
        ImGui::CalcTextSize("side").x + 2.0F * ImGui::GetStyle().FramePadding.x + gap;
    const float ends =
        text_size(theme.fonts.small, "eye").x + text_size(theme.fonts.small, "NDC").x + 2.0F * gap;
    const float room = ImGui::GetContentRegionAvail().x - button_width;
    const bool named_ends = room - ends > theme.units(16);
    ImGui::AlignTextToFramePadding();
    if (named_ends) {
        caption(theme, "eye");
        ImGui::SameLine();
    }
    ImGui::SetNextItemWidth(std::max(theme.units(6), named_ends ? room - ends : room));
    float morph = view.morph;
    if (ImGui::SliderFloat("##morph", &morph, 0.0F, last, "", ImGuiSliderFlags_AlwaysClamp)) {
        view.morph_goal.reset();
        constexpr float catches = 0.02F; // the stations themselves are easy to meet
        const float station = std::round(morph);
        set_morph(view, std::fabs(morph - station) < catches ? station : morph);
    }
    tooltip("Drag: from eye space over clip space (x, y, w) to NDC. All lines stay straight.");
    ImGui::SameLine();
    if (named_ends) {
        caption(theme, "NDC");
        ImGui::SameLine();
    }
    const char* const tip = "seen exactly from the side: distance to the right, y up";
    if (button(theme, "side", tip, {}, view.side)) {
        view.side = !view.side;
    }
}

void take_mouse(SpaceView& view) {
    constexpr float radians_per_pixel = 0.008F;
    constexpr float steepest = 1.55F;
    ImGui::SetCursorScreenPos({view.area.x, view.area.y});
    ImGui::InvisibleButton("orbit", {view.area.width, view.area.height});
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActive() && !view.side) {
        view.yaw += io.MouseDelta.x * radians_per_pixel;
        view.pitch =
            std::clamp(view.pitch + io.MouseDelta.y * radians_per_pixel, -steepest, steepest);
    }
    if (ImGui::IsItemHovered() && io.MouseWheel != 0.0F) {
        const float factor = io.MouseWheel > 0.0F ? 0.85F : 1.0F / 0.85F;
        view.distance = std::clamp(view.distance * factor, 0.15F, 8.0F);
    }
}

/// What is shown, where the way has led so far, and what is left out.
std::string note_text(const Context& context, const SpaceLines& lines, float width) {
    const SpaceView& view = context.state.space;
    std::string text{named(view.space).explanation};
    const float part = view.morph - std::floor(view.morph);
    if (is_on_the_way(view.space) && part > 0.0F) {
        text = view.morph < 1.0F
                   ? fmt::format("x and y scaled by the projection matrix: {:.0f} %", part * 100.0F)
                   : fmt::format("divided by {:.2f} + {:.2f}·w", 1.0F - part, part);
    }
    if (width < context.theme.units(60)) {
        return text; // the drawing needs the room
    }
    if (lines.edges().size() * 2 < lines.all_edges()) {
        text += fmt::format("; {} of {} edges shown", lines.edges().size(), lines.all_edges());
    }
    text += view.side ? " · wheel zooms" : " · drag turns, wheel zooms";
    return text;
}

float height_of_notes(const Theme& theme, const std::string& text, float width) {
    ImFont* font = theme.fonts.small;
    return font->CalcTextSizeA(font->FontSize, width, width, text.c_str()).y + theme.units(3);
}

} // namespace

void draw_space(Context& context, const Rect& rect, SpaceLines& lines) {
    const Theme& theme = context.theme;
    draw_toolbar(context);
    draw_morph_slider(context);
    SpaceView& view = context.state.space;
    const float pad = theme.units(3);
    const float width = rect.width - 2.0F * pad;
    const float footer = height_of_notes(theme, note_text(context, lines, width), width);
    const float top = ImGui::GetCursorScreenPos().y;
    view.area = {rect.x + pad, top, width, std::max(8.0F, rect.bottom() - footer - top)};
    take_mouse(view);
    lines.update(context.document, view);

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 corner{view.area.right(), view.area.bottom()};
    list.AddRectFilled({view.area.x, view.area.y}, corner, theme[Tone::window]);
    ImGui::PushClipRect({view.area.x, view.area.y}, corner, true);
    draw_spaces_content(context, lines);
    ImGui::PopClipRect();
    ImGui::SetCursorScreenPos({view.area.x, view.area.bottom() + theme.units(1)});
    caption(theme, note_text(context, lines, width));
}

} // namespace hs::viewer
