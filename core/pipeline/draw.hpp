// The whole pipeline of a triangle on one page: clip › divide › viewport and snap › cull › setup ›
// traverse › shade › test › merge. What comes before it, for all triangles at once, is in
// draw_frame.hpp.
#pragma once

#include "core/fragment/blend.hpp"
#include "core/framebuffer/depth.hpp"
#include "core/framebuffer/framebuffer.hpp"
#include "core/pipeline/draw_order.hpp"
#include "core/pipeline/draw_samples.hpp"
#include "core/pipeline/fault.hpp"
#include "core/pipeline/frame.hpp"
#include "core/pipeline/homogeneous.hpp"
#include "core/pipeline/narration.hpp"
#include "core/raster/traverse.hpp"

#include <limits>

namespace hs::pipeline {

/// Which part of a triangle's traversal to run: from unit `first_unit` of piece `first_piece` up
/// to, not including, unit `last_unit` of piece `last_piece`, and in `band` of the image only.
/// Geometry always runs. The default is everything.
struct TriangleScope {
    int first_piece = 0;
    int first_unit = 0;
    int last_piece = std::numeric_limits<int>::max();
    int last_unit = 0;
    PixelRect band{0, 0, std::numeric_limits<int>::max(), std::numeric_limits<int>::max()};

    [[nodiscard]] raster::UnitRange units(int piece) const {
        raster::UnitRange range;
        if (piece < first_piece || piece > last_piece) {
            range.last = 0;
        } else {
            range.first = piece == first_piece ? first_unit : 0;
            range.last = piece == last_piece ? last_unit : std::numeric_limits<int>::max();
        }
        return range;
    }
};

// What follows up to `draw_fragment` runs per fragment, where a call costs as much as the work: it
// is inlined whatever the compiler thinks of its size.

/// Test: scissor, then whether the pixel is still open, then depth. `depth` is the fragment's depth
/// as the format stores it.
template <TraceSink Trace, framebuffer::PixelTarget Target>
[[gnu::always_inline]] inline fragment::FragmentFate test_fragment(
    const DrawCall& call, PixelPos pixel, float depth, const Target& target, Trace& trace
) {
    if (call.settings.scissor) {
        const bool inside = call.settings.scissor->contains(pixel);
        trace.scissor_tested(inside);
        if (!inside) {
            return fragment::FragmentFate::scissor_failed;
        }
    }
    if (call.settings.closes_pixels()) {
        const bool open = !target.closed(pixel);
        trace.closed_tested(open);
        if (!open) {
            return fragment::FragmentFate::pixel_closed;
        }
    }
    if (call.settings.visibility == scene::Visibility::z_buffer) {
        DepthTest test{
            .depth = depth, .stored = target.depth(pixel), .op = call.settings.depth_test()};
        test.passed = scene::compare(test.op, test.depth, test.stored);
        trace.depth_tested(test);
        if (!test.passed) {
            return fragment::FragmentFate::depth_failed;
        }
    }
    return fragment::FragmentFate::written;
}

/// Merge: blend the color into the pixel, replace its depth.
template <TraceSink Trace, framebuffer::PixelTarget Target>
[[gnu::always_inline]] inline void merge_fragment(
    const DrawCall& call,
    PixelPos pixel,
    const glm::vec4& color,
    float depth,
    Target& target,
    Trace& trace
) {
    Merge merge{
        .source = color, .blended = call.settings.blend_enabled, .after = color, .depth = depth};
    if (merge.blended) {
        merge.before = target.color(pixel);
        merge.after = fragment::blend_over(merge.source, merge.before);
    }
    target.set_color(pixel, merge.after);
    merge.depth_written =
        call.settings.visibility == scene::Visibility::z_buffer && call.settings.depth_write;
    if (merge.depth_written) {
        target.set_depth(pixel, depth);
    }
    if (call.settings.closes_pixels()) {
        target.close(pixel);
    }
    trace.merged(merge);
}

/// A piece of a triangle: three clipped vertices and their place in the window.
struct Piece {
    std::array<const float*, 3> varyings{};
    std::array<geometry::WindowVertex, 3> window{};
    int number = 0;
};

/// What its fragments are made from.
struct PieceSetup {
    raster::TriangleSetup edges;
    raster::Interpolator interpolator;
};

/// Takes pieces that are set up, in place of fragments.
template <typename T>
concept PieceTarget = requires(T target, const Piece& piece, const PieceSetup& setup) {
    target.take(piece, setup);
};

/// What is interpolated over a piece.
[[nodiscard]] inline raster::Interpolants
interpolants_of(const DrawCall& call, const Piece& piece) {
    const auto& [v0, v1, v2] = piece.window;
    return {
        .depth0 = v0.window.depth,
        .depth1 = v1.window.depth,
        .depth2 = v2.window.depth,
        .inv_w0 = v0.inv_w,
        .inv_w1 = v1.inv_w,
        .inv_w2 = v2.inv_w,
        .varyings0 = piece.varyings[0],
        .varyings1 = piece.varyings[1],
        .varyings2 = piece.varyings[2],
        .varying_count = call.vertex.layout.count,
        .perspective = call.settings.interpolation == scene::InterpolationKind::perspective,
    };
}

/// Set up: edge functions, and what will be interpolated.
[[nodiscard]] inline PieceSetup set_up_piece(
    const DrawCall& call, const Piece& piece, std::int64_t doubled_area, const PixelRect& region
) {
    const auto& [v0, v1, v2] = piece.window;
    return {
        .edges = set_up_edges(call, {v0.fixed, v1.fixed, v2.fixed}, doubled_area, region),
        .interpolator = raster::Interpolator(interpolants_of(call, piece))};
}

/// A fragment's color, meaningful if it was written, and its fate.
struct FragmentOutcome {
    glm::vec4 color{0.0F};
    fragment::FragmentFate fate = fragment::FragmentFate::written;
};

/// Interpolate, then shade and test in the order the settings ask for. `fragment` is placed,
/// `interpolate(fragment)` gives it its varyings; `depth` is its depth as the format stores it.
template <TraceSink Trace, framebuffer::PixelTarget Target, typename Interpolate>
[[gnu::always_inline]] inline FragmentOutcome shade_and_test(
    const DrawCall& call,
    raster::Fragment& fragment,
    const Interpolate& interpolate,
    float depth,
    const Target& target,
    Trace& trace
) {
    FragmentOutcome outcome;
    const auto shade = [&] {
        const shading::ShadedFragment shaded =
            shading::shade(call.vertex.shading, fragment.varyings);
        trace.shaded(shaded);
        outcome.color = shaded.color;
    };
    const bool late = call.settings.depth_order == scene::DepthOrder::late;

    interpolate(fragment);
    trace.interpolated(fragment);
    if (late) {
        shade();
    }
    outcome.fate = test_fragment(call, fragment.pixel, depth, target, trace);
    if (!late && outcome.fate == fragment::FragmentFate::written) {
        shade();
    }
    return outcome;
}

/// The same for a sink that ignores values. Interpolating varyings and shading change nothing but
/// the color, so they wait until a fragment has passed its tests, whenever the settings say that
/// they happen.
template <IgnoresValues Trace, framebuffer::PixelTarget Target, typename Interpolate>
[[gnu::always_inline]] inline FragmentOutcome shade_and_test(
    const DrawCall& call,
    raster::Fragment& fragment,
    const Interpolate& interpolate,
    float depth,
    const Target& target,
    Trace& trace
) {
    const bool late = call.settings.depth_order == scene::DepthOrder::late;
    trace.interpolated(fragment);
    if (late) {
        trace.shaded({});
    }
    FragmentOutcome outcome;
    outcome.fate = test_fragment(call, fragment.pixel, depth, target, trace);
    if (outcome.fate == fragment::FragmentFate::written) {
        if (!late) {
            trace.shaded({});
        }
        interpolate(fragment);
        outcome.color = shading::shade(call.vertex.shading, fragment.varyings).color;
    }
    return outcome;
}

/// One covered pixel: its fragment, placed already, is colored, tested and merged. It is handed
/// over by reference: copying what has just been written, field by field, stalls until all of it is
/// there.
template <TraceSink Trace, framebuffer::PixelTarget Target, typename Interpolate>
[[gnu::always_inline]] inline void draw_fragment(
    const DrawCall& call,
    raster::Fragment& fragment,
    const Interpolate& interpolate,
    Target& target,
    Trace& trace
) {
    const float depth = framebuffer::store_depth(fragment.depth, call.settings.depth_format);
    const FragmentOutcome outcome =
        shade_and_test(call, fragment, interpolate, depth, target, trace);
    if (outcome.fate == fragment::FragmentFate::written) {
        merge_fragment(call, fragment.pixel, outcome.color, depth, target, trace);
    }
    trace.fragment_end(outcome.fate);
}

/// Whether some vertex of a piece has this status.
[[nodiscard]] inline bool any_vertex(const Piece& piece, geometry::WindowStatus status) {
    return piece.window[0].status == status || piece.window[1].status == status ||
           piece.window[2].status == status;
}

/// Divide, viewport, cull, setup and traverse one piece.
template <TraceSink Trace, framebuffer::PixelTarget Target>
geometry::TriangleVerdict draw_piece(
    const DrawCall& call,
    const Piece& piece,
    raster::UnitRange units,
    const PixelRect& band,
    Target& target,
    Trace& trace
) {
    using geometry::TriangleVerdict;

    // Divide by w; a vertex with w = 0 has no place
    trace.divided(piece.window);
    if (any_vertex(piece, geometry::WindowStatus::at_eye)) {
        return TriangleVerdict::behind_the_eye;
    }

    // Map to the window and snap to 1/256 pixel
    trace.mapped(piece.window);
    if (any_vertex(piece, geometry::WindowStatus::too_far)) {
        return TriangleVerdict::too_large;
    }

    // Face: the sign of the snapped area decides
    const auto& [v0, v1, v2] = piece.window;
    const std::int64_t area = geometry::doubled_area(v0.fixed, v1.fixed, v2.fixed);
    const TriangleVerdict facing =
        geometry::face_verdict(area, call.settings.front_face, call.settings.cull);
    trace.faced(area, facing);
    if (facing != TriangleVerdict::drawn) {
        return facing;
    }

    // Set up edge functions and what will be interpolated
    const PixelRect region = intersect(call.drawable(), band);
    const PieceSetup setup = set_up_piece(call, piece, area, region);
    trace.set_up(setup.edges);
    if constexpr (PieceTarget<Target>) {
        target.take(piece, setup);
    }
    if (call.settings.sweeps()) {
        return TriangleVerdict::unseen; // rows of the image draw it, all triangles at once
    }

    // Traverse: ask samples, or pixels; draw a fragment for each one covered
    if constexpr (framebuffer::SampleTarget<Target>) {
        if (call.settings.samples > 1) {
            const SampledPiece samples{setup.edges, setup.interpolator};
            return draw_samples(call, samples, region, units, target, trace);
        }
    }
    bool any = false;
    const auto interpolate = [&setup](raster::Fragment& fragment) {
        raster::interpolate_varyings(setup.interpolator, fragment);
    };
    raster::traverse(
        {call.settings.traversal, call.settings.tile_size},
        setup.edges,
        region,
        units,
        trace,
        [&](PixelPos pixel, const raster::EdgeValues& e) __attribute__((always_inline)) {
            any = true;
            raster::Fragment placed =
                raster::place_fragment(setup.interpolator, setup.edges, pixel, e);
            draw_fragment(call, placed, interpolate, target, trace);
        }
    );
    return any ? TriangleVerdict::drawn : TriangleVerdict::no_sample_covered;
}

/// The three vertices of a triangle as they enter clipping. With flat shading all carry the color
/// lit with the triangle's geometric normal at the provoking vertex; with flat interpolation, all
/// of the provoking vertex's varyings.
geometry::ClipPolygon assemble(const DrawCall& call, const scene::TriangleIndices& indices);

/// A part of a triangle as it enters clipping.
struct ShadedPart {
    geometry::ClipPolygon polygon;
    std::array<geometry::Outcode, 3> outcodes{};

    /// The planes some corner is outside of.
    [[nodiscard]] geometry::Outcode crossed() const {
        const unsigned any = outcodes[0] | outcodes[1] | outcodes[2];
        return static_cast<geometry::Outcode>(any);
    }
};

/// Its corners get position and varyings from the weights: parts that share a corner get the same.
ShadedPart
assemble(const DrawCall& call, const scene::TriangleIndices& indices, const TrianglePart& part);

/// Of the verdicts of a triangle's pieces the one that says most: any drawn piece makes the
/// triangle drawn.
[[nodiscard]] inline geometry::TriangleVerdict
stronger(geometry::TriangleVerdict a, geometry::TriangleVerdict b) {
    using geometry::TriangleVerdict;
    if (a == TriangleVerdict::drawn || b == TriangleVerdict::drawn) {
        return TriangleVerdict::drawn;
    }
    return b == TriangleVerdict::degenerate ? a : b; // slivers of a clipped triangle say little
}

/// Clips a triangle that crosses planes and draws the pieces the polygon is fanned into.
template <TraceSink Trace, framebuffer::PixelTarget Target>
// NOLINTNEXTLINE(readability-function-size): a stage is handed all it needs, and looks up nothing
geometry::TriangleVerdict draw_clipped(
    const DrawCall& call,
    const geometry::ClipPolygon& triangle,
    geometry::Outcode crossed,
    int first_piece,
    const TriangleScope& scope,
    Target& target,
    Trace& trace
) {
    const geometry::ClipPolygon polygon =
        geometry::clip_polygon(triangle, call.volume, crossed, trace);
    if (polygon.count < 3) {
        return geometry::TriangleVerdict::outside;
    }

    geometry::TriangleVerdict verdict = geometry::TriangleVerdict::degenerate;
    for (int k = 0; k + 2 < polygon.count; ++k) {
        const int piece = first_piece + k;
        Piece fan;
        fan.number = piece;
        const std::array<int, 3> corners{0, k + 1, k + 2};
        for (unsigned corner = 0; corner < 3; ++corner) {
            const geometry::ClipVertex& vertex = polygon[corners[corner]];
            fan.varyings[corner] = vertex.varyings.values.data();
            fan.window[corner] = geometry::to_window(vertex.position, call.viewport);
        }
        trace.piece_begin(piece);
        verdict =
            stronger(verdict, draw_piece(call, fan, scope.units(piece), scope.band, target, trace));
    }
    return verdict;
}

/// Draws a triangle by the planes through the eye, as it is.
template <TraceSink Trace, framebuffer::PixelTarget Target>
geometry::TriangleVerdict draw_unclipped(
    const DrawCall& call,
    const scene::TriangleIndices& indices,
    geometry::Outcode crossed,
    const TriangleScope& scope,
    Target& target,
    Trace& trace
) {
    const geometry::ClipPolygon assembled = assemble(call, indices);
    Piece whole;
    HomogeneousTriangle triangle;
    for (int corner = 0; corner < 3; ++corner) {
        const auto k = static_cast<unsigned>(corner);
        whole.varyings[k] = assembled.vertices[k].varyings.values.data();
        whole.window[k] = call.vertices[indices[corner]].window;
        triangle.clip[k] = assembled.vertices[k].position;
    }
    triangle.window = whole.window;
    trace.piece_begin(0);
    return draw_homogeneous(
        call,
        triangle,
        interpolants_of(call, whole),
        call.settings.clip_enabled ? crossed : geometry::Outcode{},
        scope.units(0),
        intersect(call.drawable(), scope.band),
        trace,
        [&](raster::Fragment complete) {
            draw_fragment(
                call, complete, [](raster::Fragment&) {}, target, trace
            );
        }
    );
}

/// One triangle through every stage after the vertex stage.
template <TraceSink Trace, framebuffer::PixelTarget Target>
// NOLINTNEXTLINE(readability-function-size): the story of a triangle stays on one page
geometry::TriangleVerdict draw_triangle(
    const DrawCall& call,
    std::uint32_t triangle,
    const TriangleScope& scope,
    Target& target,
    Trace& trace
) {
    const scene::TriangleIndices& indices = call.triangles()[triangle];
    const ShadedVertex& v0 = call.vertices[indices.a];
    const ShadedVertex& v1 = call.vertices[indices.b];
    const ShadedVertex& v2 = call.vertices[indices.c];
    trace.triangle_begin(call.object, triangle);

    // Outcodes: outside one plane with all vertices means invisible, inside all planes means
    // nothing to clip
    trace.outcodes({v0.outcode, v1.outcode, v2.outcode});
    const unsigned all = v0.outcode & v1.outcode & v2.outcode;
    const unsigned any = v0.outcode | v1.outcode | v2.outcode;
    const auto crossed = static_cast<geometry::Outcode>(any);

    geometry::TriangleVerdict verdict = geometry::TriangleVerdict::outside;
    const bool constant = call.settings.shading == scene::Shading::flat ||
                          call.settings.interpolation == scene::InterpolationKind::flat;
    const bool visible = !call.settings.clip_enabled || all == 0;
    if (visible && call.settings.draws_unclipped()) {
        verdict = draw_unclipped(call, indices, crossed, scope, target, trace);
    } else if (visible) {
        const bool clip = call.settings.clip_enabled && any != 0;
        if (clip) {
            verdict = draw_clipped(call, assemble(call, indices), crossed, 0, scope, target, trace);
        } else {
            Piece whole{
                {call.varyings_of(indices.a),
                 call.varyings_of(indices.b),
                 call.varyings_of(indices.c)},
                {v0.window, v1.window, v2.window}};
            geometry::ClipPolygon assembled;
            if (constant) {
                assembled = assemble(call, indices);
                for (unsigned k = 0; k < 3; ++k) {
                    whole.varyings[k] = assembled.vertices[k].varyings.values.data();
                }
            }
            trace.piece_begin(0);
            verdict = draw_piece(call, whole, scope.units(0), scope.band, target, trace);
        }
    }
    trace.triangle_end(verdict, crossed);
    return verdict;
}

} // namespace hs::pipeline
