// Scanline visibility: along each scanline polygons are entered and left at their edges, and only
// there, or where two penetrate, can another become visible.
//
// Wylie, Romney, Evans and Erdahl, 1967; Bouknight, A Procedure for Generation of Three-Dimensional
// Half-Toned Computer Graphics Presentations, 1970; false edges as in Watkins, 1970. Differs: what
// is visible is decided anew at every edge, on entering and on leaving, whichever polygon it is of.
#pragma once

#include "core/visibility/scan_edges.hpp"
#include "core/visibility/sweep_trace.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace hs::visibility {

/// What every scanline has in common.
struct ScanScene {
    std::vector<WindowPolygon> polygons;
    std::vector<WindowPlane> planes;
    ScanEdgeTable table;
};

/// One scanline being scanned.
struct ScanState {
    std::shared_ptr<const ScanScene> scene;
    int row = 0;
    std::vector<ActiveScanEdge> active;
    std::vector<bool> in;             ///< the polygon table's flags: the scanline is inside it
    std::vector<std::int32_t> inside; ///< polygons whose flag is up, in file order
};

/// A stretch of a scanline and the polygon visible on it.
struct ScanSpan {
    int row = 0;
    std::int32_t polygon = -1; ///< −1: the background
    double x = 0.0;
    double x_end = 0.0;
};

/// Rows `first_row` … `end_row` − 1 of the image.
[[nodiscard]] std::shared_ptr<const ScanScene>
scan_scene(std::vector<WindowPolygon> polygons, int first_row, int end_row);

/// Before a scanline: the active edges are those of the scanline above, all flags are down.
[[nodiscard]] ScanState begin_row(std::shared_ptr<const ScanScene> scene, int row);

/// Turns the flag of an edge's polygon and keeps the list of those inside. True if it is up now.
bool turn_flag(ScanState& state, std::int32_t polygon);

/// Of a polygon on the current scanline; infinitely far where it is seen edge-on.
[[nodiscard]] double scan_depth(const ScanState& state, std::int32_t polygon, double x);

namespace scanline_steps {

/// Edges that have ended go, those that begin here come, all others move on; then they are sorted.
template <SweepSink<ScanState> Sink>
void update_active(ScanState& state, Sink& sink) {
    const ScanEdgeTable& table = state.scene->table;
    for (std::size_t i = 0; i < state.active.size();) {
        const ActiveScanEdge gone = state.active[i];
        if (table.edge(gone.edge).end_row > state.row) {
            ++i;
            continue;
        }
        state.active.erase(state.active.begin() + static_cast<std::ptrdiff_t>(i));
        sink.sweep_step(
            {.kind = SweepEventKind::edge_out,
             .edge = gone.edge,
             .polygon = table.edge(gone.edge).polygon,
             .x = gone.x},
            state
        );
    }
    for (const std::int32_t edge : table.bucket(state.row)) {
        const double x = crossing(table.edge(edge), state.row);
        state.active.push_back({edge, x});
        sink.sweep_step(
            {.kind = SweepEventKind::edge_in,
             .edge = edge,
             .polygon = table.edge(edge).polygon,
             .x = x},
            state
        );
    }
    move_active(table, state.row, state.active);
    sink.sweep_step({.kind = SweepEventKind::active_edges}, state);
}

/// The polygon visible just right of `x`: the nearest there; of equal ones the one nearest at
/// `x_end`; of equal ones the first of the file.
template <SweepSink<ScanState> Sink>
[[nodiscard]] std::int32_t
nearest_inside(const ScanState& state, double x, double x_end, Sink& sink) {
    std::int32_t nearest = state.inside.front();
    for (std::size_t i = 1; i < state.inside.size(); ++i) {
        const std::int32_t other = state.inside[i];
        const std::pair own{scan_depth(state, other, x), scan_depth(state, other, x_end)};
        const std::pair best{scan_depth(state, nearest, x), scan_depth(state, nearest, x_end)};
        const bool nearer = own < best;
        sink.sweep_step(
            {.kind = SweepEventKind::compare,
             .verdict = nearer,
             .polygon = other,
             .other = nearest,
             .x = x,
             .value = own.first,
             .other_value = best.first},
            state
        );
        nearest = nearer ? other : nearest;
    }
    return nearest;
}

/// Where the first polygon inside comes through the visible one before `x_end`.
struct FalseEdge {
    std::int32_t polygon = -1; ///< −1: none does
    double x = 0.0;
};

/// Depths are linear along a scanline: what is nearer at the end has come through.
[[nodiscard]] inline FalseEdge
find_false_edge(const ScanState& state, std::int32_t visible, double x, double x_end) {
    FalseEdge first;
    double depth_at_end = 0.0;
    const double own_start = scan_depth(state, visible, x);
    const double own_end = scan_depth(state, visible, x_end);
    for (const std::int32_t other : state.inside) {
        const double start = scan_depth(state, other, x);
        const double end = scan_depth(state, other, x_end);
        if (other == visible || !(end < own_end)) {
            continue;
        }
        const double before = std::max(start - own_start, 0.0);
        const double at = x + before / (before + (own_end - end)) * (x_end - x);
        if (first.polygon < 0 || at < first.x || (at == first.x && end < depth_at_end)) {
            first = {other, at};
            depth_at_end = end;
        }
    }
    return first;
}

/// Decides what is visible between two neighboring edges.
template <SweepSink<ScanState> Sink, typename Emit>
void decide(const ScanState& state, double x, double x_end, Sink& sink, Emit&& emit) {
    const auto tell = [&](std::int32_t polygon, double from, double to) {
        sink.sweep_step(
            {.kind = SweepEventKind::span, .polygon = polygon, .x = from, .x_end = to}, state
        );
        emit(ScanSpan{state.row, polygon, from, to});
    };
    if (state.inside.empty()) {
        tell(-1, x, x_end);
        return;
    }
    std::int32_t visible = nearest_inside(state, x, x_end, sink);
    // Each that comes through is nearer at the end than the one before: every polygon does so once
    for (std::size_t i = 0; i < state.inside.size(); ++i) {
        const FalseEdge edge = find_false_edge(state, visible, x, x_end);
        if (edge.polygon < 0) {
            break;
        }
        tell(visible, x, edge.x);
        sink.sweep_step(
            {.kind = SweepEventKind::false_edge,
             .polygon = edge.polygon,
             .other = visible,
             .x = edge.x},
            state
        );
        visible = edge.polygon;
        x = edge.x;
    }
    tell(visible, x, x_end);
}

/// Along the scanline, from 0 to the image's width.
template <SweepSink<ScanState> Sink, typename Emit>
void scan_row(ScanState& state, int width, Sink& sink, Emit&& emit) {
    update_active(state, sink);
    double x = 0.0;
    for (const ActiveScanEdge& active : state.active) {
        const double next = std::clamp(active.x, 0.0, static_cast<double>(width));
        if (next > x) {
            decide(state, x, next, sink, emit);
        }
        x = next;
        const std::int32_t polygon = state.scene->table.edge(active.edge).polygon;
        const bool entered = turn_flag(state, polygon);
        sink.sweep_step(
            {.kind = SweepEventKind::cross,
             .verdict = entered,
             .edge = active.edge,
             .polygon = polygon,
             .x = active.x},
            state
        );
    }
    if (x < width) {
        decide(state, x, width, sink, emit);
    }
}

} // namespace scanline_steps

/// Emits the spans of a row from left to right, without a gap. Pixel i shows a span from x to
/// x_end if x <= i + ½ < x_end: from `first_pixel(x)` on. Needs nothing of other rows.
template <SweepSink<ScanState> Sink, typename Emit>
void scan_row(
    const std::shared_ptr<const ScanScene>& scene, int row, int width, Sink& sink, Emit&& emit
) {
    ScanState state = begin_row(scene, row);
    scanline_steps::scan_row(state, width, sink, emit);
}

/// All rows of an image.
template <SweepSink<ScanState> Sink, typename Emit>
void scan_visible(
    std::vector<WindowPolygon> polygons, int width, int height, Sink& sink, Emit&& emit
) {
    const auto scene = scan_scene(std::move(polygons), 0, height);
    for (int row = 0; row < height; ++row) {
        scan_row(scene, row, width, sink, emit);
    }
}

} // namespace hs::visibility
