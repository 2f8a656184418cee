// The inspector's tab of values: every number of the step by name; an opened one shows its formula,
// and its operands lead to the steps they came from.
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/step_values.hpp"

#include <fmt/format.h>

namespace hs::viewer {
namespace {

using explain::ExpressionPtr;
using explain::StepValue;

std::string with_unit(const explain::Expression& e) {
    const std::string_view unit = explain::unit_of(e);
    return explain::value_text(e) + (unit.empty() ? "" : " ") + std::string{unit};
}

/// What the value was before the scene was changed; empty where it is the same, or no change was
/// made at this step.
std::string text_before(Context& context, const StepValue& value) {
    const ValuesBefore& before = context.state.values_before;
    if (before.step.empty() ||
        before.step != trace::step_path(context.document.player().current())) {
        return "";
    }
    const auto found = before.texts.find(value.name);
    const bool same =
        found != before.texts.end() && found->second == explain::value_text(*value.expression);
    return found == before.texts.end() || same ? "" : found->second;
}

/// A row that can be clicked: a name on the left, a value on the right.
bool value_row(
    const Theme& theme, const std::string& name, const std::string& value, bool chosen, Tone tone
) {
    const UseFont use{theme.fonts.small_mono};
    const float right = ImGui::GetContentRegionAvail().x;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::Selectable("##value", chosen);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float width = text_size(theme.fonts.small_mono, value).x;
    const std::string shown = shorten(theme.fonts.small_mono, name, right - width - theme.units(2));
    draw_text(list, theme.fonts.small_mono, at, theme[tone], shown);
    draw_text(list, theme.fonts.small_mono, {at.x + right - width, at.y}, theme[Tone::text], value);
    return clicked;
}

/// Behind the row that follows.
void mark_changed(const Theme& theme) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 end{
        at.x + ImGui::GetContentRegionAvail().x, at.y + theme.fonts.small_mono->FontSize};
    ImGui::GetWindowDrawList()->AddRectFilled(at, end, theme[Tone::changed]);
}

void draw_operand(Context& context, const ExpressionPtr& operand, bool chosen) {
    const bool leads = !operand->origin.step.empty();
    const std::string name = (leads ? "→ " : "   ") + operand->symbol;
    const Tone tone = leads ? Tone::accent : Tone::quiet;
    if (value_row(context.theme, name, with_unit(*operand), chosen, tone) && leads) {
        context.viewer.follow(operand->origin);
    }
    const std::string origin = explain::origin_text(operand->origin);
    if (!origin.empty()) {
        tooltip(leads ? fmt::format("{}\nclick goes there", origin) : origin);
    }
}

void draw_opened(Context& context, const StepValue& value) {
    const Theme& theme = context.theme;
    const explain::Expression& expression = *value.expression;
    ImGui::Indent(theme.units(2));
    small_mono(theme, "= " + explain::in_symbols(expression));
    small_mono(theme, "= " + explain::in_numbers(expression), Tone::quiet);
    small_mono(
        theme,
        fmt::format("= {} {}", explain::exact_text(expression), explain::unit_of(expression)),
        Tone::quiet
    );
    int index = 0;
    for (const ExpressionPtr& operand : explain::operands_of(value.expression)) {
        ImGui::PushID(index);
        draw_operand(context, operand, index == context.state.values.operand);
        ImGui::PopID();
        ++index;
    }
    ImGui::Unindent(theme.units(2));
    ImGui::Dummy({0.0F, theme.units(1)});
}

} // namespace

void draw_values_tab(Context& context) {
    const Theme& theme = context.theme;
    ValueTrail& trail = context.state.values;
    const std::vector<StepValue>& values = context.document.values();
    const std::string why = context.viewer.why_not(Command::value_back);
    const std::string to = trail.back.empty() ? "" : trail.back.back().value;
    if (button(theme, "← back", "to the value you came from; Backspace", why)) {
        context.viewer.run(Command::value_back);
    }
    if (!to.empty()) {
        ImGui::SameLine();
        caption(theme, to);
    }
    if (values.empty()) {
        empty_note(theme, "This step computes nothing. Every other step lists its numbers here.");
        return;
    }
    int index = 0;
    for (const StepValue& value : values) {
        ImGui::PushID(index++);
        const bool open = value.name == trail.open;
        const std::string before = text_before(context, value);
        if (!before.empty()) {
            mark_changed(theme);
        }
        if (value_row(theme, value.name, with_unit(*value.expression), open, Tone::text)) {
            trail.open = open ? "" : value.name;
            trail.operand = -1;
        }
        if (!before.empty()) {
            caption(theme, fmt::format("   was {}", before));
        }
        if (open && trail.scroll) {
            ImGui::SetScrollHereY(0.3F);
            trail.scroll = false;
        }
        if (open) {
            draw_opened(context, value);
        }
        ImGui::PopID();
    }
}

} // namespace hs::viewer
