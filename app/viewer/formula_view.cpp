#include "app/viewer/formula_view.hpp"

#include "app/viewer/lesson_pointer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>

namespace hs::viewer {

void draw_formula(const Context& context, const explain::Formula& formula, bool lit) {
    const Theme& theme = context.theme;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.ChannelsSplit(2);
    list.ChannelsSetCurrent(1);
    ImGui::BeginGroup();
    words(theme, formula.title, lit ? Tone::accent : Tone::text);
    if (!formula.symbolic.empty()) {
        caption(theme, formula.symbolic);
    }
    {
        const UseFont use{theme.fonts.small_mono};
        ImGui::PushTextWrapPos(0.0F);
        if (!formula.with_numbers.empty()) {
            ImGui::PushStyleColor(ImGuiCol_Text, theme[Tone::quiet]);
            ImGui::TextUnformatted(formula.with_numbers.c_str());
            ImGui::PopStyleColor();
        }
        const std::string value = "= " + formula.value;
        ImGui::TextUnformatted(value.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::EndGroup();
    list.ChannelsSetCurrent(0);
    if (lit) {
        const float x = start.x - theme.units(2);
        list.AddRectFilled(
            {x, start.y}, {x + theme.pixels(3), ImGui::GetItemRectMax().y}, theme[Tone::accent]
        );
    }
    if (points_at_any(context.viewer, formula.quantities)) {
        draw_pointing_frame(list, theme, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    }
    list.ChannelsMerge();
    ImGui::Dummy({0.0F, theme.units(1)});
}

void draw_matrix(const Theme& theme, std::string_view title, const glm::mat4& matrix) {
    caption(theme, title);
    const UseFont use{theme.fonts.small_mono};
    for (int r = 0; r < 4; ++r) {
        const std::string line = fmt::format(
            "{:>9} {:>9} {:>9} {:>9}",
            explain::number(matrix[0][r]),
            explain::number(matrix[1][r]),
            explain::number(matrix[2][r]),
            explain::number(matrix[3][r])
        );
        ImGui::TextUnformatted(line.c_str());
    }
}

void draw_step_formulas(const Context& context, std::span<const explain::Formula> formulas) {
    for (const explain::Formula& formula : formulas) {
        draw_formula(context, formula, true);
    }
}

} // namespace hs::viewer
