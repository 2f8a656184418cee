// Whatever comes next in the order of draws: a triangle, a part of one, a line or a point, or a row
// of the image.
#pragma once

#include "core/pipeline/draw_line.hpp"
#include "core/pipeline/run_sweep.hpp"

namespace hs::pipeline {

/// A part of a triangle that an ordering algorithm has cut, through the same stages.
template <TraceSink Trace, framebuffer::PixelTarget Target>
geometry::TriangleVerdict draw_part(
    const DrawCall& call,
    std::uint32_t triangle,
    const TrianglePart& part,
    const TriangleScope& scope,
    Target& target,
    Trace& trace
) {
    const ShadedPart shaded = assemble(call, call.triangles()[triangle], part);
    trace.triangle_begin(call.object, triangle);
    trace.part_begin(part.first_piece);
    trace.outcodes(shaded.outcodes);
    const unsigned all = shaded.outcodes[0] & shaded.outcodes[1] & shaded.outcodes[2];
    const bool clip = call.settings.clip_enabled;
    geometry::TriangleVerdict verdict = geometry::TriangleVerdict::outside;
    if (!clip || all == 0) {
        const geometry::Outcode crossed = clip ? shaded.crossed() : geometry::Outcode{};
        verdict =
            draw_clipped(call, shaded.polygon, crossed, part.first_piece, scope, target, trace);
    }
    trace.triangle_end(verdict, shaded.crossed());
    return verdict;
}

/// A triangle that the ordering found no moment for: it is left out of the picture.
template <TraceSink Trace>
geometry::TriangleVerdict pass_over(const DrawCall& call, std::uint32_t triangle, Trace& trace) {
    const scene::TriangleIndices& indices = call.triangles()[triangle];
    const std::array codes{
        call.vertices[indices.a].outcode,
        call.vertices[indices.b].outcode,
        call.vertices[indices.c].outcode};
    const unsigned any = codes[0] | codes[1] | codes[2];
    trace.triangle_begin(call.object, triangle);
    trace.outcodes(codes);
    trace.triangle_end(geometry::TriangleVerdict::stuck, static_cast<geometry::Outcode>(any));
    return geometry::TriangleVerdict::stuck;
}

/// Runs the draw through all stages that are its own.
template <TraceSink Trace, framebuffer::PixelTarget Target>
geometry::TriangleVerdict run_draw(
    const Frame& frame,
    const DrawOrder& order,
    const Draw& draw,
    const TriangleScope& scope,
    Target& target,
    Trace& trace
) {
    if (draw.row >= 0) {
        run_sweep(frame, *order.sweep, draw.row, scope, target, trace);
        return geometry::TriangleVerdict::drawn;
    }
    const DrawCall& call = frame.calls()[draw.object];
    if (draw.stuck) {
        return pass_over(call, draw.triangle, trace);
    }
    if (frame.settings().visibility == scene::Visibility::ray_cast) {
        return face_triangle(call, draw.triangle, trace);
    }
    if (draw.triangle >= call.triangles().size()) {
        return draw_line(call, draw.triangle, scope, target, trace);
    }
    if (draw.part < 0) {
        return draw_triangle(call, draw.triangle, scope, target, trace);
    }
    const TrianglePart& part = order.parts[static_cast<std::size_t>(draw.part)];
    return draw_part(call, draw.triangle, part, scope, target, trace);
}

} // namespace hs::pipeline
