// Several samples a pixel: coverage and depth are decided sample by sample.
//
// OpenGL 4.6, section 14.3.1 (multisampling): one color, from the pixel's center, for all samples a
// fragment covers, even where the center is not covered (varyings are not `centroid`). Section
// 14.3.1.1 (sample shading): supersampling makes every covered sample a fragment of its own.
#pragma once

#include "core/fragment/blend.hpp"
#include "core/framebuffer/depth.hpp"
#include "core/framebuffer/framebuffer.hpp"
#include "core/pipeline/frame.hpp"
#include "core/pipeline/narration.hpp"
#include "core/raster/traverse.hpp"

namespace hs::pipeline {

/// A piece as its samples see it.
struct SampledPiece {
    const raster::TriangleSetup& edges;
    const raster::Interpolator& interpolator;
    raster::SampleSteps steps{}; ///< filled in by the traversal
};

/// The samples of a pixel that a fragment stands for, and where its varyings are taken.
struct SampledFragment {
    PixelPos pixel;
    raster::EdgeValues center{}; ///< edge values at the pixel's center
    raster::CoverageMask covered = 0;
    int sample = -1; ///< the one it is shaded at; −1: the pixel's center
};

/// The fragment's depth at a sample, as the format stores it: a pure function of setup and sample.
[[nodiscard]] inline float depth_at_sample(
    const DrawCall& call, const SampledPiece& piece, const raster::EdgeValues& center, int sample
) {
    const raster::EdgeValues edges = piece.steps.at(center, sample);
    const raster::Fragment placed =
        raster::place_fragment(piece.interpolator, piece.edges, {}, edges);
    return framebuffer::store_depth(placed.depth, call.settings.depth_format);
}

/// Scissor, then the depth of every covered sample. What is left of the fragment's samples.
template <TraceSink Trace>
raster::CoverageMask test_samples(
    const DrawCall& call,
    const SampledFragment& fragment,
    const std::array<float, raster::max_samples>& depths,
    const framebuffer::PixelSamples& held,
    fragment::FragmentFate& fate,
    Trace& trace
) {
    if (call.settings.scissor) {
        const bool inside = call.settings.scissor->contains(fragment.pixel);
        trace.scissor_tested(inside);
        if (!inside) {
            fate = fragment::FragmentFate::scissor_failed;
            return 0;
        }
    }
    if (call.settings.visibility != scene::Visibility::z_buffer) {
        return fragment.covered;
    }
    unsigned passed = 0;
    for (int s = 0; s < held.count; ++s) {
        if (!raster::has_sample(fragment.covered, s)) {
            continue;
        }
        const unsigned later = static_cast<unsigned>(fragment.covered) >> (s + 1);
        DepthTest test{
            .depth = depths[static_cast<unsigned>(s)],
            .stored = held[s].depth,
            .op = call.settings.depth_test(),
            .sample = s};
        test.passed = scene::compare(test.op, test.depth, test.stored);
        passed |= test.passed ? 1U << static_cast<unsigned>(s) : 0U;
        test.discards = later == 0 && passed == 0;
        trace.depth_tested(test);
    }
    if (passed == 0) {
        fate = fragment::FragmentFate::depth_failed;
    }
    return static_cast<raster::CoverageMask>(passed);
}

/// Blends the color into every sample that passed, and replaces its depth.
template <TraceSink Trace, framebuffer::SampleTarget Target>
// NOLINTNEXTLINE(readability-function-size): a stage is handed all it needs, and looks up nothing
void merge_samples(
    const DrawCall& call,
    PixelPos pixel,
    const glm::vec4& color,
    const std::array<float, raster::max_samples>& depths,
    SamplesMerge& merge,
    Target& target,
    Trace& trace
) {
    merge.source = color;
    merge.blended = call.settings.blend_enabled;
    merge.depth_written =
        call.settings.visibility == scene::Visibility::z_buffer && call.settings.depth_write;
    merge.after = merge.before;
    for (int s = 0; s < merge.before.count; ++s) {
        if (!raster::has_sample(merge.written, s)) {
            continue;
        }
        framebuffer::SampleValue& sample = merge.after[s];
        sample.color = merge.blended ? fragment::blend_over(color, sample.color) : color;
        if (merge.depth_written) {
            sample.depth = depths[static_cast<unsigned>(s)];
        }
    }
    target.set_samples(pixel, merge.after);
    trace.samples_merged(merge);
}

/// Interpolate, shade, test and merge one fragment of a pixel with several samples.
template <TraceSink Trace, framebuffer::SampleTarget Target>
void draw_sampled_fragment(
    const DrawCall& call,
    const SampledPiece& piece,
    const SampledFragment& sampled,
    Target& target,
    Trace& trace
) {
    // Depth at every sample of the pixel; those it does not cover are not asked
    std::array<float, raster::max_samples> depths{};
    for (int s = 0; s < piece.steps.count; ++s) {
        depths[static_cast<unsigned>(s)] = depth_at_sample(call, piece, sampled.center, s);
    }
    trace.fragment_sampled({sampled.covered, sampled.sample, depths[0]});

    // Varyings where it is shaded: the pixel's center, or its one sample
    raster::Fragment fragment = raster::place_fragment(
        piece.interpolator,
        piece.edges,
        sampled.pixel,
        sampled.sample < 0 ? sampled.center : piece.steps.at(sampled.center, sampled.sample)
    );
    raster::interpolate_varyings(piece.interpolator, fragment);
    trace.interpolated(fragment);

    // Shade once and test every sample, in the order the settings ask for
    const bool late = call.settings.depth_order == scene::DepthOrder::late;
    glm::vec4 color{0.0F};
    const auto shade = [&] {
        const shading::ShadedFragment shaded =
            shading::shade(call.vertex.shading, fragment.varyings);
        trace.shaded(shaded);
        color = shaded.color;
    };
    if (late) {
        shade();
    }
    SamplesMerge merge;
    merge.before = target.samples(sampled.pixel);
    auto fate = fragment::FragmentFate::written;
    merge.written = test_samples(call, sampled, depths, merge.before, fate, trace);
    if (fate == fragment::FragmentFate::written) {
        if (!late) {
            shade();
        }
        merge_samples(call, sampled.pixel, color, depths, merge, target, trace);
    }
    trace.fragment_end(fate);
}

/// One pixel with covered samples: one fragment for all of them, or with supersampling one each.
template <TraceSink Trace, framebuffer::SampleTarget Target>
void draw_sampled_pixel(
    const DrawCall& call,
    const SampledPiece& piece,
    const SampledFragment& all,
    Target& target,
    Trace& trace
) {
    if (call.settings.sampling != scene::Sampling::supersample) {
        draw_sampled_fragment(call, piece, all, target, trace);
        return;
    }
    for (int s = 0; s < piece.steps.count; ++s) {
        if (raster::has_sample(all.covered, s)) {
            SampledFragment one = all;
            one.covered = raster::mask_of(s);
            one.sample = s;
            draw_sampled_fragment(call, piece, one, target, trace);
        }
    }
}

/// Traverses a piece, finding the samples that it covers.
template <TraceSink Trace, framebuffer::SampleTarget Target>
[[gnu::noinline]] geometry::TriangleVerdict draw_samples(
    const DrawCall& call,
    SampledPiece piece,
    const PixelRect& region,
    raster::UnitRange units,
    Target& target,
    Trace& trace
) {
    const raster::SampledSetup setup = raster::at_samples(piece.edges, call.settings.samples);
    piece.steps = setup.samples;
    auto verdict = geometry::TriangleVerdict::no_sample_covered;
    raster::traverse(
        {call.settings.traversal, call.settings.tile_size},
        setup,
        region,
        units,
        trace,
        [&](PixelPos pixel, const raster::EdgeValues& center, raster::CoverageMask covered) {
            verdict = geometry::TriangleVerdict::drawn;
            draw_sampled_pixel(call, piece, {pixel, center, covered}, target, trace);
        }
    );
    return verdict;
}

/// Resolve: every pixel becomes the average of its samples, row by row.
template <TraceSink Trace, framebuffer::SampleTarget Target>
void resolve_frame(const scene::Settings& settings, Target& target, Trace& trace) {
    for (int y = 0; y < settings.height; ++y) {
        for (int x = 0; x < settings.width; ++x) {
            const framebuffer::PixelSamples held = target.samples({x, y});
            const framebuffer::SampleValue resolved =
                framebuffer::resolve(held, settings.color_format);
            target.set_color({x, y}, resolved.color);
            target.set_depth({x, y}, resolved.depth);
            trace.resolved({x, y}, held, resolved);
        }
    }
}

} // namespace hs::pipeline
