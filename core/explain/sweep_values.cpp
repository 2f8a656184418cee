// The values of the decisions of scanlines and rays: where an edge crosses the scanline, and depths
// on the planes of polygons. What a ray's meeting and a stretch's ends are stands as it was decided.
#include "core/explain/sweep.hpp"
#include "core/explain/value_list.hpp"

#include <fmt/format.h>

#include <limits>

namespace hs::explain {
namespace {

using visibility::ScanState;
using visibility::SweepEvent;
using visibility::SweepEventKind;

Wide given(const std::string& symbol, double value, const std::string& origin) {
    return operand(symbol, value, {{}, {}, origin});
}

/// x = x0 + (y − y0) · Δx / Δy
Wide crossing_term(const visibility::ScanEdge& edge, const std::string& label, int row) {
    const std::string ends = fmt::format("the upper and lower end of edge {} in the window", label);
    const Wide x0 = given("x0", edge.top.x, ends);
    const Wide y0 = given("y0", edge.top.y, ends);
    const Wide x1 = given("x1", edge.bottom.x, ends);
    const Wide y1 = given("y1", edge.bottom.y, ends);
    const Wide y = given("y", visibility::scanline(row), "the scanline");
    return x0 + (y - y0) * ((x1 - x0) / (y1 - y0));
}

/// z = −(a x + b y + d) / c; infinitely far where the plane is seen edge-on.
Wide depth_term(const StepContext& context, const ScanState& state, std::int32_t polygon, double x) {
    const auto& plane = state.scene->planes[static_cast<std::size_t>(polygon)];
    const std::string of = "the plane of " + swept_name(context.recording, polygon);
    if (plane.normal.z == 0.0) {
        return given("z", std::numeric_limits<double>::infinity(), of + ", seen edge-on");
    }
    const Wide sum = given("a", plane.normal.x, of) * given("x", x, "the place asked") +
                     given("b", plane.normal.y, of) *
                         given("y", visibility::scanline(state.row), "the scanline") +
                     given("d", plane.offset, of);
    return -sum / given("c", plane.normal.z, of);
}

void add_edge(ValueList& list, const StepContext& context, const trace::SweepDetail& detail) {
    const ScanState& state = *detail.scan;
    const std::int32_t edge = detail.last().edge;
    list.add(
        "x",
        crossing_term(
            state.scene->table.edge(edge),
            edge_label(context.recording, *state.scene, edge),
            state.row
        )
    );
}

void add_comparison(ValueList& list, const StepContext& context, const trace::SweepDetail& detail) {
    const SweepEvent& event = detail.last();
    list.add("value", depth_term(context, *detail.scan, event.polygon, event.x));
    list.add("other value", depth_term(context, *detail.scan, event.other, event.x));
    list.add(
        "verdict",
        operand("verdict", event.verdict, {{}, {}, "depths here, and where the stretch ends"})
    );
}

/// The line holds what polygons before this one left there.
void add_pixel(ValueList& list, const StepContext& context, const trace::SweepDetail& detail) {
    const SweepEvent& event = detail.last();
    const Wide own =
        list.add("value", depth_term(context, *detail.scan, event.polygon, event.x + 0.5));
    const Wide held = list.add("other value", given("z", event.other_value, "the line of depths"));
    list.add("verdict", call<bool>(operations::less, own, held));
}

void add_nearer_hit(ValueList& list, const StepContext& context, const SweepEvent& event) {
    const std::string name = swept_name(context.recording, event.polygon);
    const Wide own = list.add("value", given("t", event.value, "the hit of " + name));
    const Wide kept = list.add("other value", given("t", event.other_value, "the hit kept so far"));
    list.add("verdict", call<bool>(operations::less, own, kept));
}

void add_as_decided(ValueList& list, const SweepEvent& event) {
    const std::string origin = fmt::format("decided by {}", name_of(event.kind));
    list.add("x", given("x", event.x, origin));
    list.add("x end", given("x end", event.x_end, origin));
    list.add("value", given("value", event.value, origin));
    list.add("verdict", operand("verdict", event.verdict, {{}, {}, origin}));
}

} // namespace

void add_sweep_values(ValueList& list, const StepContext& context) {
    const trace::SweepDetail detail = trace::sweep_detail(context.recording, context.step);
    switch (detail.last().kind) {
    case SweepEventKind::edge_in: return add_edge(list, context, detail);
    case SweepEventKind::compare: return add_comparison(list, context, detail);
    case SweepEventKind::depth: return add_pixel(list, context, detail);
    case SweepEventKind::keep: return add_nearer_hit(list, context, detail.last());
    case SweepEventKind::edge_out:
    case SweepEventKind::active_edges:
    case SweepEventKind::cross:
    case SweepEventKind::false_edge:
    case SweepEventKind::span:
    case SweepEventKind::clear:
    case SweepEventKind::enter:
    case SweepEventKind::cast:
    case SweepEventKind::meet: return add_as_decided(list, detail.last());
    }
}

} // namespace hs::explain
