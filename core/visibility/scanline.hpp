// Scanline visibility: along each scanline polygons are entered and left at their edges, and only
// there, or where two penetrate, can another become visible.
//
// Wylie, Romney, Evans and Erdahl, 1967; Bouknight, A Procedure for Generation of Three-Dimensional
// Half-Toned Computer Graphics Presentations, 1970; false edges as in Watkins, 1970. Differs: what
// is visible is decided anew at every edge, on entering and on leaving, whichever polygon it is of.
#pragma once

#include "core/visibility/scan_edges.hpp"

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace hs::visibility {

enum class ScanEventKind : std::uint8_t {
    active_edges, ///< the active edges of `row`
    cross,        ///< `edge` at `x`: its `polygon` is entered (verdict) or left
    compare,      ///< at `x`, is `polygon` (depth `value`) in front of `other` (`other_value`)?
    false_edge,   ///< at `x`, inside both, `polygon` comes through `other`
    span          ///< `polygon` (−1: the background) is visible from `x` to `x_end`
};

struct ScanEvent {
    ScanEventKind kind = ScanEventKind::active_edges;
    bool verdict = false;
    int row = 0;
    std::int32_t edge = -1;
    std::int32_t polygon = -1;
    std::int32_t other = -1;
    double x = 0.0;
    double x_end = 0.0;
    double value = 0.0;
    double other_value = 0.0;
};

struct ScanState {
    std::vector<WindowPolygon> polygons;
    std::vector<WindowPlane> planes;
    ScanEdgeTable table;
    int row = 0;
    std::vector<ActiveScanEdge> active;
    std::vector<bool> in;             ///< the polygon table's flags: the scanline is inside it
    std::vector<std::int32_t> inside; ///< polygons whose flag is up, in file order
};

/// Takes the story; never steers. `State` as with `OrderSink`.
template <typename Sink, typename State>
concept ScanSink = requires(Sink sink, const ScanEvent& event, const State& state) {
    { sink.scan_step(event, state) } -> std::same_as<void>;
};

struct SilentScan {
    template <typename State>
    void scan_step(const ScanEvent&, const State&) {}
};

/// A stretch of a scanline and the polygon visible on it.
struct ScanSpan {
    int row = 0;
    std::int32_t polygon = -1; ///< −1: the background
    double x = 0.0;
    double x_end = 0.0;
};

[[nodiscard]] ScanState begin_scan(std::vector<WindowPolygon> polygons, int first_row, int end_row);

/// Turns the flag of an edge's polygon and keeps the list of those inside. True if it is up now.
bool turn_flag(ScanState& state, std::int32_t polygon);

/// Of a polygon on the current scanline; infinitely far where it is seen edge-on.
[[nodiscard]] double scan_depth(const ScanState& state, std::int32_t polygon, double x);

namespace scanline_steps {

/// The polygon visible just right of `x`: the nearest there; of equal ones the one nearest at
/// `x_end`; of equal ones the first of the file.
template <ScanSink<ScanState> Sink>
[[nodiscard]] std::int32_t
nearest_inside(const ScanState& state, double x, double x_end, Sink& sink) {
    std::int32_t nearest = state.inside.front();
    for (std::size_t i = 1; i < state.inside.size(); ++i) {
        const std::int32_t other = state.inside[i];
        const std::pair own{scan_depth(state, other, x), scan_depth(state, other, x_end)};
        const std::pair best{scan_depth(state, nearest, x), scan_depth(state, nearest, x_end)};
        const bool nearer = own < best;
        sink.scan_step(
            {.kind = ScanEventKind::compare,
             .verdict = nearer,
             .row = state.row,
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
template <ScanSink<ScanState> Sink, typename Emit>
void decide(const ScanState& state, double x, double x_end, Sink& sink, Emit&& emit) {
    const auto tell = [&](std::int32_t polygon, double from, double to) {
        sink.scan_step(
            {.kind = ScanEventKind::span,
             .row = state.row,
             .polygon = polygon,
             .x = from,
             .x_end = to},
            state
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
        sink.scan_step(
            {.kind = ScanEventKind::false_edge,
             .row = state.row,
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

/// One scanline, from 0 to the image's width.
template <ScanSink<ScanState> Sink, typename Emit>
void scan_row(ScanState& state, int width, Sink& sink, Emit&& emit) {
    double x = 0.0;
    for (const ActiveScanEdge& active : state.active) {
        const double next = std::clamp(active.x, 0.0, static_cast<double>(width));
        if (next > x) {
            decide(state, x, next, sink, emit);
        }
        x = next;
        const std::int32_t polygon =
            state.table.edges[static_cast<std::size_t>(active.edge)].polygon;
        const bool entered = turn_flag(state, polygon);
        sink.scan_step(
            {.kind = ScanEventKind::cross,
             .verdict = entered,
             .row = state.row,
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

/// Emits the spans of the rows from left to right, covering each row of the image without a gap.
/// Pixel i shows a span from x to x_end if x <= i + ½ < x_end: from `first_pixel(x)` on.
template <ScanSink<ScanState> Sink, typename Emit>
void scan_visible(
    std::vector<WindowPolygon> polygons, int width, int height, Sink& sink, Emit&& emit
) {
    ScanState state = begin_scan(std::move(polygons), 0, height);
    for (state.row = 0; state.row < height; ++state.row) {
        update_active(state.table, state.row, state.active);
        sink.scan_step({.kind = ScanEventKind::active_edges, .row = state.row}, state);
        scanline_steps::scan_row(state, width, sink, emit);
    }
}

} // namespace hs::visibility
