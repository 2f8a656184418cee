// A whole frame: the stages that run for all vertices and all triangles at once, then every
// triangle through its own (run_draw.hpp).
#pragma once

#include "core/base/parallel.hpp"
#include "core/pipeline/order.hpp"
#include "core/pipeline/row_bands.hpp"
#include "core/pipeline/run_draw.hpp"

#include <type_traits>

namespace hs::pipeline {

/// The vertex stage of one object. Vertices do not depend on each other, so threads may share them;
/// the story is told in order all the same.
template <TraceSink Trace>
void run_vertex_stage(DrawCall& call, Trace& trace, unsigned threads = 1) {
    constexpr std::size_t grain = 4096;
    const std::size_t count = call.vertex.mesh->positions.size();
    call.resize_vertices(count);
    parallel_ranges(count, threads, grain, [&call](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const VertexWork work = run_vertex(call.vertex, static_cast<std::uint32_t>(i));
            call.place_vertex(i, {work.clip, work.varyings});
        }
    });
    const int steps = steps_per_vertex(call.settings.shading);
    for (std::uint32_t i = 0; i < count; ++i) {
        trace.vertex_run(call.object, i, steps);
    }
}

/// The rows of a band, of everything in its order, without a story.
template <framebuffer::PixelTarget Target>
void draw_band(const Frame& frame, const DrawOrder& order, const PixelRect& band, Target& target) {
    NullTrace nothing;
    for (const Draw& draw : order.draws) {
        if (frame.settings().sweeps()) {
            if (draw.row >= 0) { // what triangles are by themselves is known to the sweep
                run_draw(frame, order, draw, {.band = band}, target, nothing);
            }
            continue;
        }
        const DrawCall& call = frame.calls()[draw.object];
        const std::vector<ShadedVertex>& v = call.vertices;
        const scene::Primitive primitive = call.primitive(draw.triangle);
        const auto& [a, b, c] = primitive.vertices;
        // A part's rounding may reach a hair beyond its triangle, a line's beyond its vertices
        const bool whole = draw.part < 0 && primitive.kind == scene::PrimitiveKind::triangle;
        if (!whole || !misses(band, v[a], v[b], v[c])) {
            run_draw(frame, order, draw, {.band = band}, target, nothing);
        }
    }
}

/// Everything on several threads: each draws its own rows.
template <framebuffer::PixelTarget Target>
void draw_bands(const Frame& frame, const DrawOrder& order, Target& target, unsigned threads) {
    const std::vector<PixelRect> bands = balanced_bands(frame, threads);
    parallel_ranges(bands.size(), threads, 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            draw_band(frame, order, bands[i], target);
        }
    });
}

/// Every object's vertices.
template <TraceSink Trace>
void shade_vertices(Frame& frame, Trace& trace, unsigned threads = 1) {
    for (DrawCall& call : frame.calls()) {
        run_vertex_stage(call, trace, threads);
    }
}

/// Every triangle, in file order or in the one that the settings' algorithm finds. Where nobody
/// listens, threads share the rows.
template <TraceSink Trace, framebuffer::PixelTarget Target>
requires AnyOrderSink<Trace> && AnySweepSink<Trace>
void draw_triangles(const Frame& frame, Target& target, Trace& trace, unsigned threads = 1) {
    const DrawOrder order = order_triangles(frame, trace);
    if (std::is_same_v<Trace, NullTrace> && threads > 1) {
        draw_bands(frame, order, target, threads);
    } else {
        for (const Draw& draw : order.draws) {
            run_draw(frame, order, draw, {}, target, trace);
        }
    }
    if constexpr (framebuffer::SampleTarget<Target>) {
        if (frame.settings().samples > 1) {
            resolve_frame(frame.settings(), target, trace);
        }
    }
}

/// A whole frame: vertices, then triangles. Precondition: `refuse_order` would not complain.
template <TraceSink Trace, framebuffer::PixelTarget Target>
requires AnyOrderSink<Trace> && AnySweepSink<Trace>
void draw_frame(Frame& frame, Target& target, Trace& trace, unsigned threads = 1) {
    shade_vertices(frame, trace, threads);
    draw_triangles(frame, target, trace, threads);
}

} // namespace hs::pipeline
