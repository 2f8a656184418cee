// A z-buffer of one line: scanline after scanline, every active polygon's pixels are compared with
// what the line holds. Its memory does not grow with the height of the image.
//
// Myers, An Efficient Visible Surface Program, 1975; Carpenter, A New Hidden Surface Algorithm,
// 1976.
#pragma once

#include "core/visibility/scanline.hpp"

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace hs::visibility {

/// The line: per pixel the nearest depth so far and whose it is (−1: nobody's).
struct LineBuffer {
    int row = 0;
    std::vector<double> depth;
    std::vector<std::int32_t> polygon;
};

/// Hears of active edges, then of the line.
template <typename Sink>
concept LineSink = SweepSink<Sink, ScanState> && SweepSink<Sink, LineBuffer>;

/// Pixels of one polygon on one scanline.
struct PixelSpan {
    std::int32_t polygon = -1;
    int x = 0;
    int x_end = 0;
};

/// Of the active edges of a scanline: polygons in file order, pixels within [0, width).
[[nodiscard]] std::vector<PixelSpan> pixel_spans(const ScanState& state, int width);

/// Stretches of a finished line that show one polygon, or the background, from left to right.
[[nodiscard]] std::vector<PixelSpan> visible_spans(const LineBuffer& line);

namespace line_steps {

template <LineSink Sink>
void enter(const ScanState& state, const PixelSpan& span, LineBuffer& line, Sink& sink) {
    sink.sweep_step(
        {.kind = SweepEventKind::enter,
         .polygon = span.polygon,
         .x = static_cast<double>(span.x),
         .x_end = static_cast<double>(span.x_end)},
        line
    );
    for (int x = span.x; x < span.x_end; ++x) {
        const auto i = static_cast<std::size_t>(x);
        SweepEvent event{
            .kind = SweepEventKind::depth,
            .polygon = span.polygon,
            .other = line.polygon[i],
            .x = static_cast<double>(x),
            .value = scan_depth(state, span.polygon, x + 0.5),
            .other_value = line.depth[i]};
        event.verdict = event.value < event.other_value;
        if (event.verdict) {
            line.depth[i] = event.value;
            line.polygon[i] = span.polygon;
        }
        sink.sweep_step(event, line);
    }
}

} // namespace line_steps

/// One row, which needs nothing of others; `emit(line)` when it is finished. Of equally deep
/// polygons the first of the file stays.
template <LineSink Sink, typename Emit>
void scan_row_with_line_buffer(
    const std::shared_ptr<const ScanScene>& scene, int row, int width, Sink& sink, Emit&& emit
) {
    ScanState state = begin_row(scene, row);
    scanline_steps::update_active(state, sink);
    LineBuffer line;
    line.row = row;
    line.depth.assign(static_cast<std::size_t>(width), std::numeric_limits<double>::infinity());
    line.polygon.assign(static_cast<std::size_t>(width), -1);
    sink.sweep_step({.kind = SweepEventKind::clear}, line);
    for (const PixelSpan& span : pixel_spans(state, width)) {
        line_steps::enter(state, span, line, sink);
    }
    emit(std::as_const(line));
}

/// All rows of an image.
template <LineSink Sink, typename Emit>
void scan_with_line_buffer(
    std::vector<WindowPolygon> polygons, int width, int height, Sink& sink, Emit&& emit
) {
    const auto scene = scan_scene(std::move(polygons), 0, height);
    for (int row = 0; row < height; ++row) {
        scan_row_with_line_buffer(scene, row, width, sink, emit);
    }
}

} // namespace hs::visibility
