#include "app/viewer/order_rows.hpp"

#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/order.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hs::viewer {
namespace {

constexpr int rows_shown = 200;

void go_to(Context& context, const pipeline::OrderedPolygon& polygon) {
    context.viewer.seek(trace::last_step_of_triangle(context.document.recording(), polygon.triangle)
    );
}

} // namespace

DecidedPair decided_pair(const visibility::OrderEvent& decision) {
    DecidedPair pair{{decision.polygon, {}}, {decision.other, {}}};
    using Kind = visibility::OrderEventKind;
    const bool tests = decision.kind == Kind::test || decision.kind == Kind::exchanged_test;
    if (decision.kind == Kind::compare || (tests && decision.verdict)) {
        pair.first.first = decision.verdict;
        pair.second.first = !decision.verdict;
    }
    return pair;
}

Tone tone_of(const std::optional<bool>& first) {
    return !first ? Tone::accent : *first ? Tone::pass : Tone::fail;
}

bool stands_on_decision(const Context& context) {
    return context.document.player().current().kind == trace::StepKind::order;
}

std::string
full_name(const Context& context, const trace::OrderDetail& detail, std::int32_t polygon) {
    const auto found = detail.polygon(polygon);
    return found ? explain::polygon_name(context.document.recording(), *found) : "–";
}

std::string
label_of(const Context& context, const trace::OrderDetail& detail, std::int32_t polygon) {
    const auto found = detail.polygon(polygon);
    return found ? explain::polygon_label(context.document.recording(), *found) : "–";
}

void light(OrderRow& row, const DecidedPair& pair) {
    for (const DecidedPolygon& decided : {pair.first, pair.second}) {
        if (decided.index == row.polygon) {
            row.lit = tone_of(decided.first);
            row.first = decided.first;
        }
    }
}

void light_drawn(const Context& context, const trace::OrderDetail& detail, OrderRow& row) {
    const auto triangle = context.document.current_triangle();
    const auto polygon = detail.polygon(row.polygon);
    if (triangle && polygon && *triangle >= polygon->triangle &&
        *triangle < polygon->triangle + polygon->triangle_count) {
        row.lit = Tone::accent;
    }
}

void draw_order_row(
    Context& context, const trace::OrderDetail& detail, const OrderRow& row, float width
) {
    const Theme& theme = context.theme;
    const UseFont use{theme.fonts.small_mono};
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight() + theme.units(1);
    if (row.polygon < 0) {
        ImGui::Dummy({width, height});
        return;
    }
    const auto polygon = detail.polygon(row.polygon);
    if (ImGui::InvisibleButton("row", {width, height})) {
        go_to(context, *polygon);
        return;
    }
    const std::string name = full_name(context, detail, row.polygon);
    tooltip(name + ". Click to go to where it is drawn.");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{start.x + width, start.y + height};
    if (row.lit || ImGui::IsItemHovered()) {
        list.AddRectFilled(start, end, theme.faded(row.lit.value_or(Tone::accent), 0.22F));
    }
    if (row.lit) {
        list.AddRectFilled(start, {start.x + theme.pixels(3), end.y}, theme[*row.lit]);
    }
    const float mark = theme.units(4);
    const float y = start.y + theme.units(0.5F);
    if (row.first) {
        const float radius = theme.units(1);
        const ImVec2 center{start.x + theme.units(2) + theme.pixels(2), start.y + 0.5F * height};
        draw_mark(list, center, radius, *row.first, theme);
    }
    const float number_width = text_size(theme.fonts.small_mono, row.text).x;
    const float room = width - mark - number_width - theme.units(2);
    const std::string label = label_of(context, detail, row.polygon);
    const std::string shown = fitting(theme.fonts.small_mono, {name, label}, room);
    draw_text(list, theme.fonts.small_mono, {start.x + mark, y}, theme[row.tone], shown);
    draw_text(
        list, theme.fonts.small_mono, {start.x + 0.4F * width, y}, theme[row.tone], row.middle
    );
    const float x = end.x - number_width - theme.units(1);
    draw_text(list, theme.fonts.small_mono, {x, y}, theme[row.tone], row.text);
}

RowRange rows_around(int focus, int count) {
    const int first = std::clamp(focus - rows_shown / 2, 0, std::max(0, count - rows_shown));
    return {first, std::min(count, first + rows_shown)};
}

} // namespace hs::viewer
