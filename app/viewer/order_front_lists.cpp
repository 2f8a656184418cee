// The table of the front lists: polygon, front list, polygons behind, drawn or not.
#include "app/viewer/order_views.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/order.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hs::viewer {
namespace {

/// "4 3 1", cut where a column has no room for more.
std::string list_text(
    const Context& context, const trace::OrderDetail& detail, const std::vector<std::int32_t>& list
) {
    constexpr std::size_t most = 6;
    std::string text;
    for (std::size_t i = 0; i < std::min(list.size(), most); ++i) {
        text += text.empty() ? "" : " ";
        text += label_of(context, detail, list[i]);
    }
    return list.size() > most ? text + " …" : text.empty() ? "–" : text;
}

std::string counter_text(const visibility::FrontLists& lists, std::int32_t polygon) {
    const std::int32_t behind = lists.behind[static_cast<std::size_t>(polygon)];
    const bool stuck =
        std::find(lists.stuck.begin(), lists.stuck.end(), polygon) != lists.stuck.end();
    return behind < 0 ? "−1" : stuck ? fmt::format("{} stuck", behind) : fmt::format("{}", behind);
}

} // namespace

void draw_front_lists(Context& context, const trace::OrderDetail& detail) {
    const Theme& theme = context.theme;
    const auto& lists = std::get<visibility::FrontLists>(detail.state);
    heading(theme, "Polygon, front list, polygons behind");
    caption(theme, "Nothing behind, 0: it can be drawn. −1: it is drawn.");
    const DecidedPair pair = decided_pair(detail.decision);
    const bool deciding = stands_on_decision(context);
    const int focus = deciding ? std::max(0, pair.first.index) : 0;
    const RowRange range = rows_around(focus, static_cast<int>(lists.polygons.size()));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.0F});
    for (int i = range.first; i < range.last; ++i) {
        const std::int32_t polygon = i;
        const auto index = static_cast<std::size_t>(i);
        OrderRow row{
            .polygon = polygon,
            .text = counter_text(lists, polygon),
            .middle = list_text(context, detail, lists.in_front[index])};
        row.tone = lists.behind[index] < 0 ? Tone::quiet : Tone::text;
        if (deciding) {
            light(row, pair);
        } else {
            light_drawn(context, detail, row);
        }
        ImGui::PushID(i);
        draw_order_row(context, detail, row, ImGui::GetContentRegionAvail().x);
        ImGui::PopID();
    }
    ImGui::PopStyleVar();
    if (!lists.order.empty()) {
        std::string drawn;
        for (const std::int32_t polygon : lists.order) {
            drawn += drawn.empty() ? "" : ", ";
            drawn += label_of(context, detail, polygon);
        }
        heading(
            theme,
            fmt::format(
                "Drawn, in {} iteration{}", lists.iterations, lists.iterations == 1 ? "" : "s"
            )
        );
        mono(theme, drawn);
    }
}

} // namespace hs::viewer
