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

enum class LineEventKind : std::uint8_t {
    clear, ///< the line is cleared for `row`
    enter, ///< `polygon` covers pixels `x` … `x_end` − 1 of the row
    test   ///< pixel `x`: is `polygon` (depth `value`) nearer than the line's (`other_value`)?
};

struct LineEvent {
    LineEventKind kind = LineEventKind::clear;
    bool verdict = false;
    int row = 0;
    std::int32_t polygon = -1;
    int x = 0;
    int x_end = 0;
    double value = 0.0;
    double other_value = 0.0;
};

/// The line: per pixel the nearest depth so far and whose it is (−1: nobody's).
struct LineBuffer {
    int row = 0;
    std::vector<double> depth;
    std::vector<std::int32_t> polygon;
};

/// Takes the story; never steers.
template <typename Sink>
concept LineSink = requires(Sink sink, const LineEvent& event, const LineBuffer& line) {
    { sink.line_step(event, line) } -> std::same_as<void>;
};

struct SilentLine {
    void line_step(const LineEvent&, const LineBuffer&) {}
};

/// Pixels of one polygon on one scanline.
struct PixelSpan {
    std::int32_t polygon = -1;
    int x = 0;
    int x_end = 0;
};

/// Of the active edges of a scanline: polygons in file order, pixels within [0, width).
[[nodiscard]] std::vector<PixelSpan> pixel_spans(const ScanState& state, int width);

namespace line_steps {

template <LineSink Sink>
void enter(const ScanState& state, const PixelSpan& span, LineBuffer& line, Sink& sink) {
    sink.line_step(
        {.kind = LineEventKind::enter,
         .row = line.row,
         .polygon = span.polygon,
         .x = span.x,
         .x_end = span.x_end},
        line
    );
    for (int x = span.x; x < span.x_end; ++x) {
        const auto i = static_cast<std::size_t>(x);
        LineEvent event{
            .kind = LineEventKind::test,
            .row = line.row,
            .polygon = span.polygon,
            .x = x,
            .value = scan_depth(state, span.polygon, x + 0.5),
            .other_value = line.depth[i]};
        event.verdict = event.value < event.other_value;
        if (event.verdict) {
            line.depth[i] = event.value;
            line.polygon[i] = span.polygon;
        }
        sink.line_step(event, line);
    }
}

} // namespace line_steps

/// `emit(line)` for every row when it is finished. Of equally deep polygons the first of the file
/// stays.
template <LineSink Sink, typename Emit>
void scan_with_line_buffer(
    std::vector<WindowPolygon> polygons, int width, int height, Sink& sink, Emit&& emit
) {
    ScanState state = begin_scan(std::move(polygons), 0, height);
    LineBuffer line;
    for (int row = 0; row < height; ++row) {
        state.row = line.row = row;
        update_active(state.table, row, state.active);
        line.depth.assign(static_cast<std::size_t>(width), std::numeric_limits<double>::infinity());
        line.polygon.assign(static_cast<std::size_t>(width), -1);
        sink.line_step({.kind = LineEventKind::clear, .row = row}, line);
        for (const PixelSpan& span : pixel_spans(state, width)) {
            line_steps::enter(state, span, line, sink);
        }
        emit(std::as_const(line));
    }
}

} // namespace hs::visibility
