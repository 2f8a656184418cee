// Order: how the order in which triangles are drawn is found, and how far the drawing is.
#include "app/viewer/formula_view.hpp"
#include "app/viewer/order_rows.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"
#include "core/explain/order.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hs::viewer {
namespace {

using visibility::OrderEventKind;

std::string depth(double value) {
    return explain::number(static_cast<float>(value));
}

bool stands_on_decision(const Context& context) {
    return context.document.player().current().kind == trace::StepKind::order;
}

/// How often each kind of decision was made: now, of the frame.
void draw_counts(Context& context) {
    const Theme& theme = context.theme;
    const trace::OrderCounts now = context.document.player().counters().decisions;
    const trace::OrderCounts& all = context.document.recording().counters.decisions;
    for (const Named<OrderEventKind>& kind : names<OrderEventKind>()) {
        const auto i = static_cast<std::size_t>(kind.value);
        if (all[i] > 0) {
            row(theme, kind.name, fmt::format("{} of {}", now[i], all[i]));
        }
    }
}

/// The polygon whose triangle is being drawn, if one is.
std::optional<std::uint32_t> drawn_now(const Context& context) {
    return context.document.current_triangle();
}

bool is_of(const pipeline::OrderedPolygon& polygon, const std::optional<std::uint32_t>& triangle) {
    return triangle && *triangle >= polygon.triangle &&
           *triangle < polygon.triangle + polygon.triangle_count;
}

/// Both columns of a merge: the runs so far, and what they become.
class PaintersLists {
public:
    PaintersLists(Context& context, const trace::OrderDetail& detail)
        : context_(context),
          detail_(detail),
          sort_(std::get<visibility::PaintersSort>(detail.state)),
          pair_(decided_pair(detail.decision)),
          deciding_(stands_on_decision(context)) {}

    void draw() {
        const Theme& theme = context_.theme;
        const bool merging = deciding_ && sort_.run < sort_.list.size();
        heading(
            theme,
            merging ? fmt::format("Sorted runs of {}, and what they become", sort_.run)
                    : std::string{"Painted from top to bottom"}
        );
        const float gap = theme.units(2);
        const float room = ImGui::GetContentRegionAvail().x;
        const float width = merging ? 0.5F * (room - gap) : room;
        const RowRange range = rows_around(focus(merging), static_cast<int>(sort_.list.size()));
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, 0.0F});
        for (int i = range.first; i < range.last; ++i) {
            const auto place = static_cast<std::size_t>(i);
            if (merging && place % sort_.run == 0) {
                ImGui::Separator();
            }
            ImGui::PushID(i);
            draw_order_row(context_, detail_, list_row(sort_.list[place], merging), width);
            if (merging) {
                ImGui::SameLine();
                ImGui::PushID("next");
                draw_order_row(context_, detail_, moved_row(place), width);
                ImGui::PopID();
            }
            ImGui::PopID();
        }
        ImGui::PopStyleVar();
    }

private:
    [[nodiscard]] int focus(bool merging) const {
        return static_cast<int>(merging ? sort_.moved.size() : sort_.order.size());
    }
    [[nodiscard]] bool was_moved(std::int32_t polygon) const {
        return std::find(sort_.moved.begin(), sort_.moved.end(), polygon) != sort_.moved.end();
    }
    [[nodiscard]] bool was_emitted(std::int32_t polygon) const {
        return std::find(sort_.order.begin(), sort_.order.end(), polygon) != sort_.order.end();
    }

    [[nodiscard]] OrderRow list_row(std::int32_t polygon, bool merging) const {
        OrderRow result{.polygon = polygon, .text = depth(sort_.key(polygon))};
        const bool gone = merging ? was_moved(polygon) : deciding_ && !was_emitted(polygon);
        result.tone = gone ? Tone::quiet : Tone::text;
        const bool moving = detail_.decision.kind == OrderEventKind::move;
        if (deciding_ && !(merging && moving)) {
            light(result);
        } else if (!deciding_ && is_of(*detail_.polygon(polygon), drawn_now(context_))) {
            result.lit = Tone::accent;
        }
        return result;
    }
    [[nodiscard]] OrderRow moved_row(std::size_t place) const {
        if (place >= sort_.moved.size()) {
            return {};
        }
        OrderRow result{
            .polygon = sort_.moved[place], .text = depth(sort_.key(sort_.moved[place]))};
        if (detail_.decision.kind == OrderEventKind::move) {
            light(result);
        }
        return result;
    }
    void light(OrderRow& row) const {
        for (const DecidedPolygon& decided : {pair_.first, pair_.second}) {
            if (decided.index == row.polygon) {
                row.lit = tone_of(decided.first);
                row.first = decided.first;
            }
        }
    }

    Context& context_;
    const trace::OrderDetail& detail_;
    const visibility::PaintersSort& sort_;
    DecidedPair pair_;
    bool deciding_;
};

void draw_formulas(Context& context, const trace::OrderDetail& detail) {
    if (!stands_on_decision(context)) {
        return;
    }
    for (const explain::Formula& formula :
         explain::order_formulas(context.document.recording(), detail)) {
        draw_formula(context, formula, true);
    }
}

} // namespace

void draw_order(Context& context) {
    const Theme& theme = context.theme;
    const scene::Settings& settings = context.document.recording().settings();
    if (!settings.orders_triangles()) {
        empty_note(
            theme,
            "Triangles are drawn in file order here. With visibility = \"painters\" you will see "
            "how they are sorted."
        );
        return;
    }
    heading(theme, fmt::format("{}: now, of the frame", name_of(settings.visibility)));
    draw_counts(context);
    const trace::OrderDetail* detail = context.document.order_detail();
    if (detail == nullptr) {
        caption(theme, "Step on to the visibility stage to see the order being found.");
        return;
    }
    if (std::holds_alternative<visibility::PaintersSort>(detail->state)) {
        PaintersLists(context, *detail).draw();
    }
    draw_formulas(context, *detail);
}

} // namespace hs::viewer
