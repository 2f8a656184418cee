// A row of the image that shows what is nearest of all triangles: the algorithm decides, then what
// it found goes through shading, tests and merging like every fragment.
#pragma once

#include "core/pipeline/sweep.hpp"

namespace hs::pipeline {

/// Pixels [x, x_end) of a row show a piece.
template <TraceSink Trace, framebuffer::PixelTarget Target>
void draw_swept(
    const Frame& frame,
    const Sweep& sweep,
    const visibility::PixelSpan& span,
    int row,
    Target& target,
    Trace& trace
) {
    const PixelRect region = swept_region(frame);
    const int first = std::max(span.x, region.x0);
    const int end = std::min(span.x_end, region.x1);
    if (span.polygon < 0 || first >= end) {
        return;
    }
    const PieceName& piece = sweep.polygon(span.polygon);
    const PieceSetup& setup = sweep.setups[static_cast<std::size_t>(span.polygon)];
    const DrawCall& call = frame.calls()[piece.object];
    const auto interpolate = [&setup](raster::Fragment& fragment) {
        raster::interpolate_varyings(setup.interpolator, fragment);
    };
    trace.shown(piece);
    for (int x = first; x < end; ++x) {
        const PixelPos pixel{x, row};
        raster::Fragment placed = raster::place_fragment(
            setup.interpolator, setup.edges, pixel, setup.edges.evaluate(pixel)
        );
        draw_fragment(call, placed, interpolate, target, trace);
    }
}

/// Every span is drawn as soon as it is found.
template <TraceSink Trace, framebuffer::PixelTarget Target>
requires AnySweepSink<Trace>
void run_scanline(const Frame& frame, const Sweep& sweep, int row, Target& target, Trace& trace) {
    visibility::scan_row(
        sweep.scan,
        row,
        frame.settings().width,
        trace,
        [&](const visibility::ScanSpan& span) {
            const visibility::PixelSpan pixels{
                span.polygon, visibility::first_pixel(span.x), visibility::first_pixel(span.x_end)};
            draw_swept(frame, sweep, pixels, row, target, trace);
        }
    );
}

/// The line is drawn when all polygons have been held against it.
template <TraceSink Trace, framebuffer::PixelTarget Target>
requires AnySweepSink<Trace>
void run_line_buffer(
    const Frame& frame, const Sweep& sweep, int row, Target& target, Trace& trace
) {
    const int width = frame.settings().width;
    const auto draw_line = [&](const visibility::LineBuffer& line) {
        for (const visibility::PixelSpan& span : visibility::visible_spans(line)) {
            draw_swept(frame, sweep, span, row, target, trace);
        }
    };
    visibility::scan_row_with_line_buffer(sweep.scan, row, width, trace, draw_line);
}

/// Unit k is the ray of the row's k-th pixel.
template <TraceSink Trace, framebuffer::PixelTarget Target>
requires AnySweepSink<Trace>
void run_rays(
    const Frame& frame,
    const Sweep& sweep,
    int row,
    raster::UnitRange units,
    Target& target,
    Trace& trace
) {
    const PixelRect region = swept_region(frame);
    const int last = std::min(units.last, region.width());
    for (int unit = units.first; unit < last; ++unit) {
        const PixelPos pixel{region.x0 + unit, row};
        trace.pixel_begin(pixel);
        trace.unit(unit);
        const visibility::RayCast cast =
            visibility::cast_ray(pixel_ray(frame, sweep, pixel), sweep.triangles, trace);
        if (cast.nearest < 0) {
            continue;
        }
        const PieceName& hit = sweep.polygon(cast.nearest);
        const DrawCall& call = frame.calls()[hit.object];
        trace.shown(hit);
        raster::Fragment fragment = hit_fragment(call, hit.triangle, pixel, cast.meeting.weights);
        draw_fragment(
            call, fragment, [](raster::Fragment&) {}, target, trace
        );
    }
}

/// One row. Scanlines are one unit of work, rays one each.
template <TraceSink Trace, framebuffer::PixelTarget Target>
requires AnySweepSink<Trace>
void run_sweep(
    const Frame& frame,
    const Sweep& sweep,
    int row,
    const TriangleScope& scope,
    Target& target,
    Trace& trace
) {
    if (row < scope.band.y0 || row >= scope.band.y1) {
        return;
    }
    trace.sweep_begin(row);
    const scene::Visibility visibility = frame.settings().visibility;
    if (visibility == scene::Visibility::scanline) {
        run_scanline(frame, sweep, row, target, trace);
    } else if (visibility == scene::Visibility::scanline_z) {
        run_line_buffer(frame, sweep, row, target, trace);
    } else {
        run_rays(frame, sweep, row, scope.units(0), target, trace);
    }
}

/// All that ray casting asks of a triangle by itself: which side is seen.
template <TraceSink Trace>
geometry::TriangleVerdict
face_triangle(const DrawCall& call, std::uint32_t triangle, Trace& trace) {
    const scene::TriangleIndices& indices = call.triangles()[triangle];
    const unsigned crossed = call.vertices[indices.a].outcode | call.vertices[indices.b].outcode |
                             call.vertices[indices.c].outcode;
    trace.triangle_begin(call.object, triangle);
    trace.piece_begin(0);
    const SeenSide side = seen_side(call, triangle);
    trace.oriented(side.determinant, side.verdict);
    const geometry::TriangleVerdict verdict = side.verdict == geometry::TriangleVerdict::drawn
                                                  ? geometry::TriangleVerdict::unseen
                                                  : side.verdict;
    trace.triangle_end(verdict, static_cast<geometry::Outcode>(crossed));
    return verdict;
}

} // namespace hs::pipeline
