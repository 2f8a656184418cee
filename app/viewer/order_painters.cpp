// The painter's merge: runs that are sorted already, beside what they become.
#include "app/viewer/order_views.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hs::viewer {
namespace {

using visibility::OrderEventKind;

std::string depth(double value) {
    return explain::number(static_cast<float>(value));
}

/// Draws one state: two columns while runs are merged, the finished list afterwards.
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
            light(result, pair_);
        } else if (!deciding_) {
            light_drawn(context_, detail_, result);
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
            light(result, pair_);
        }
        return result;
    }

    Context& context_;
    const trace::OrderDetail& detail_;
    const visibility::PaintersSort& sort_;
    DecidedPair pair_;
    bool deciding_;
};

} // namespace

void draw_painters(Context& context, const trace::OrderDetail& detail) {
    PaintersLists(context, detail).draw();
}

} // namespace hs::viewer
