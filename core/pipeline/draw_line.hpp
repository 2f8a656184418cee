// Lines and points through every stage after the vertex stage: the same divide, viewport, shading,
// tests and merging as for triangles; no facing, and a walk instead of a traversal.
//
// A line counts as a triangle whose last two corners are its second vertex, a point as one with
// three equal corners: tables, sinks and panels carry them without knowing. A point is a line from
// a pixel to itself.
#pragma once

#include "core/geometry/clip_segment.hpp"
#include "core/pipeline/draw.hpp"
#include "core/raster/line_bresenham.hpp"
#include "core/raster/line_dda.hpp"

namespace hs::pipeline {

/// Divide, viewport, setup and walk. The third vertex of the piece repeats the second.
template <TraceSink Trace, framebuffer::PixelTarget Target>
geometry::TriangleVerdict draw_segment(
    const DrawCall& call,
    const Piece& piece,
    raster::UnitRange units,
    const PixelRect& band,
    Target& target,
    Trace& trace
) {
    using geometry::TriangleVerdict;
    trace.piece_begin(0);
    trace.divided(piece.window);
    if (any_vertex(piece, geometry::WindowStatus::at_eye)) {
        return TriangleVerdict::behind_the_eye;
    }
    trace.mapped(piece.window);
    if (any_vertex(piece, geometry::WindowStatus::too_far)) {
        return TriangleVerdict::too_large;
    }

    // Set up: end pixels, and what will be interpolated
    const raster::LineSetup line =
        raster::set_up_line(piece.window[0].fixed, piece.window[1].fixed);
    const raster::Interpolator interpolator(interpolants_of(call, piece));
    trace.line_set_up(line);
    if (units.first > 0 || units.last <= 0) {
        return TriangleVerdict::drawn; // geometry only: the walk is one unit
    }

    // Walk: a fragment at every pixel
    bool any = false;
    const auto interpolate = [&interpolator](raster::Fragment& fragment) {
        raster::interpolate_varyings(interpolator, fragment);
    };
    const auto emit = [&](PixelPos pixel) {
        any = true;
        const float t = raster::fraction_along(line, pixel);
        raster::Fragment placed;
        placed.pixel = pixel;
        placed.barycentric = {1.0F - t, t, 0.0F};
        placed.depth = interpolator.depth(t, 0.0F);
        draw_fragment(call, placed, interpolate, target, trace);
    };
    const PixelRect region = intersect(call.drawable(), band);
    trace.unit(0);
    if (call.settings.line_algorithm == scene::LineAlgorithm::dda) {
        raster::walk_dda(line, region, trace, emit);
    } else {
        raster::walk_bresenham(line, region, trace, emit);
    }
    return any ? TriangleVerdict::drawn : TriangleVerdict::no_sample_covered;
}

/// One line or point of an object.
template <TraceSink Trace, framebuffer::PixelTarget Target>
geometry::TriangleVerdict draw_line(
    const DrawCall& call,
    std::uint32_t primitive,
    const TriangleScope& scope,
    Target& target,
    Trace& trace
) {
    const scene::TriangleIndices ends = call.primitive(primitive).vertices;
    const geometry::Outcode out0 = call.vertices[ends.a].outcode;
    const geometry::Outcode out1 = call.vertices[ends.b].outcode;
    trace.triangle_begin(call.object, primitive);
    trace.outcodes({out0, out1, out1});
    const auto crossed = static_cast<geometry::Outcode>(out0 | out1);
    const bool clip = call.settings.clip_enabled && crossed != 0;

    geometry::TriangleVerdict verdict = geometry::TriangleVerdict::outside;
    geometry::ClipPolygon segment = assemble(call, ends);
    segment.count = 2;
    if (clip) {
        const bool rejected = (out0 & out1) != 0;
        segment = rejected ? geometry::ClipPolygon{}
                           : geometry::clip_segment(segment, call.volume, crossed, trace);
    }
    if (segment.count == 2) {
        Piece piece;
        for (unsigned k = 0; k < 3; ++k) {
            const geometry::ClipVertex& vertex = segment.vertices[std::min(k, 1U)];
            piece.varyings[k] = vertex.varyings.values.data();
            piece.window[k] = geometry::to_window(vertex.position, call.viewport);
        }
        verdict = draw_segment(call, piece, scope.units(0), scope.band, target, trace);
    }
    trace.triangle_end(verdict, crossed);
    return verdict;
}

} // namespace hs::pipeline
