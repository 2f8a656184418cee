// Order: how the order in which triangles are drawn is found, and how far the drawing is.
#include "app/viewer/formula_view.hpp"
#include "app/viewer/order_views.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/sweep_views.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/order.hpp"

#include <fmt/format.h>

namespace hs::viewer {
namespace {

using visibility::OrderEventKind;

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

void draw_state(Context& context, const trace::OrderDetail& detail) {
    const trace::OrderState& state = detail.state;
    if (std::holds_alternative<visibility::PaintersSort>(state)) {
        draw_painters(context, detail);
    } else if (std::holds_alternative<visibility::FrontLists>(state)) {
        draw_front_lists(context, detail);
    } else if (std::holds_alternative<visibility::DepthSort>(state)) {
        draw_depth_sort(context, detail);
    } else if (std::holds_alternative<trace::BspMoment>(state)) {
        draw_bsp_tree(context, detail);
    } else if (std::holds_alternative<trace::OctreeMoment>(state)) {
        draw_octree(context, detail);
    }
}

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
    if (settings.sweeps()) {
        draw_sweep(context);
        return;
    }
    if (!settings.orders_triangles()) {
        empty_note(
            theme,
            "Triangles are drawn in file order here. With visibility painters, front-lists, "
            "newell-sancha, bsp or octree you will see how their order is found; with scanline, "
            "scanline-z or ray-cast, how every row of the image finds the nearest."
        );
        return;
    }
    heading(theme, fmt::format("{}: now, of the frame", name_of(settings.visibility)));
    draw_counts(context);
    const trace::OrderDetail* detail = context.document.order_detail();
    if (context.document.recording().decisions.size() > Document::most_decisions) {
        caption(theme, "Too many decisions to show the list or the tree around each.");
        return;
    }
    if (detail == nullptr) {
        caption(theme, "Step on to the visibility stage to see the order being found.");
        return;
    }
    draw_state(context, *detail);
    draw_formulas(context, *detail);
}

} // namespace hs::viewer
