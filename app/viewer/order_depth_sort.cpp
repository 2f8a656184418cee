// Depth sort: the pair with its tests, and the list that is left.
#include "app/viewer/order_views.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"
#include "core/visibility/order_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace hs::viewer {
namespace {

using visibility::OrderEvent;
using visibility::OrderEventKind;

/// What the tests of one pair have said so far.
struct Verdicts {
    std::array<std::optional<bool>, 6> tests;
    std::array<std::optional<bool>, 6> exchanged;
};

bool is_test(const OrderEvent& event) {
    return event.kind == OrderEventKind::test || event.kind == OrderEventKind::exchanged_test;
}

bool same_pair(const OrderEvent& a, const OrderEvent& b) {
    return (a.polygon == b.polygon && a.other == b.other) ||
           (a.polygon == b.other && a.other == b.polygon);
}

/// From the log, back to where the pair was first asked.
Verdicts verdicts_until(const trace::OrderLog& log, std::size_t last) {
    Verdicts verdicts;
    for (std::size_t i = last + 1; i-- > 0 && is_test(log[i]) && same_pair(log[i], log[last]);) {
        const OrderEvent& event = log[i];
        auto& answers = event.kind == OrderEventKind::test ? verdicts.tests : verdicts.exchanged;
        answers[static_cast<std::size_t>(event.place)] = event.verdict;
    }
    return verdicts;
}

void draw_verdict(const Theme& theme, const std::string& label, const std::optional<bool>& passed) {
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight();
    if (passed) {
        const ImVec2 center{start.x + theme.units(2), start.y + 0.5F * line};
        draw_mark(*ImGui::GetWindowDrawList(), center, theme.units(1), *passed, theme);
    }
    ImGui::SetCursorScreenPos({start.x + theme.units(4), start.y});
    caption(theme, label, passed ? Tone::text : Tone::quiet);
}

void draw_tests(Context& context, const trace::OrderDetail& detail) {
    const Theme& theme = context.theme;
    const trace::OrderLog& log = context.document.recording().decisions;
    const Verdicts verdicts = verdicts_until(log, context.document.player().current().event);
    const bool exchanged = detail.decision.kind == OrderEventKind::exchanged_test;
    const std::int32_t p = exchanged ? detail.decision.other : detail.decision.polygon;
    const std::int32_t q = exchanged ? detail.decision.polygon : detail.decision.other;
    heading(
        theme,
        fmt::format("P {}, Q {}", full_name(context, detail, p), full_name(context, detail, q))
    );
    for (const Named<visibility::NewellTest>& test : names<visibility::NewellTest>()) {
        const auto i = static_cast<std::size_t>(test.value);
        draw_verdict(theme, fmt::format("{} {}", i, test.explanation), verdicts.tests[i]);
    }
    for (const std::size_t i : {std::size_t{3}, std::size_t{4}}) {
        if (verdicts.exchanged[i]) {
            draw_verdict(theme, fmt::format("{} with P and Q exchanged", i), verdicts.exchanged[i]);
        }
    }
}

} // namespace

void draw_depth_sort(Context& context, const trace::OrderDetail& detail) {
    const Theme& theme = context.theme;
    const auto& sort = std::get<visibility::DepthSort>(detail.state);
    const bool deciding = stands_on_decision(context);
    if (deciding && is_test(detail.decision)) {
        draw_tests(context, detail);
    }
    heading(
        theme,
        fmt::format("Drawn {}, left {}, from the farthest", sort.order.size(), sort.list.size())
    );
    std::vector<std::int32_t> all{sort.order};
    all.insert(all.end(), sort.list.begin(), sort.list.end());
    const DecidedPair pair = decided_pair(detail.decision);
    const RowRange range =
        rows_around(static_cast<int>(sort.order.size()), static_cast<int>(all.size()));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.0F});
    for (int i = range.first; i < range.last; ++i) {
        const std::int32_t polygon = all[static_cast<std::size_t>(i)];
        const auto& sorted = sort.sorted[static_cast<std::size_t>(polygon)];
        const bool drawn = static_cast<std::size_t>(i) < sort.order.size();
        OrderRow row{
            .polygon = polygon,
            .text = (sorted.marked && !drawn ? "moved " : "") +
                    explain::number(static_cast<float>(sorted.extents.high.z))};
        row.tone = drawn && deciding ? Tone::quiet : Tone::text;
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
}

} // namespace hs::viewer
