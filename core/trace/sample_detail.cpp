#include "core/trace/sample_detail.hpp"

#include "core/framebuffer/depth.hpp"
#include "core/raster/interpolation.hpp"
#include "core/raster/sample_coverage.hpp"

namespace hs::trace {
namespace {

/// Depth alone: no varyings.
raster::Interpolator depth_of(const std::array<geometry::WindowVertex, 3>& window) {
    static constexpr std::array<float, math::max_varyings> nothing{};
    return raster::Interpolator(
        {.depth0 = window[0].window.depth,
         .depth1 = window[1].window.depth,
         .depth2 = window[2].window.depth,
         .varyings0 = nothing.data(),
         .varyings1 = nothing.data(),
         .varyings2 = nothing.data()}
    );
}

} // namespace

std::vector<SampleDetail> samples_of_piece(
    const Recording& recording,
    const raster::TriangleSetup& setup,
    const std::array<geometry::WindowVertex, 3>& window,
    const Step& step
) {
    const scene::Settings& settings = recording.frame->calls()[step.object].settings;
    const raster::SampleSteps steps = raster::sample_steps(setup, settings.samples);
    const raster::Interpolator interpolator = depth_of(window);
    const raster::EdgeValues center = setup.evaluate(step.pixel);
    std::vector<SampleDetail> samples;
    for (int s = 0; s < settings.samples; ++s) {
        SampleDetail& sample = samples.emplace_back();
        sample.offset = raster::sample_pattern(settings.samples)[static_cast<std::size_t>(s)];
        sample.edges = steps.at(center, s);
        sample.covered = setup.covers(sample.edges);
        const raster::Fragment placed =
            raster::place_fragment(interpolator, setup, step.pixel, sample.edges);
        sample.depth = framebuffer::store_depth(placed.depth, settings.depth_format);
    }
    if (step.in_fragment()) {
        const FragmentRecord& fragment = recording.fragments[step.fragment];
        const framebuffer::PixelSamples before = recording.samples.after(fragment.previous);
        const framebuffer::PixelSamples after = recording.samples.after(step.fragment);
        for (int s = 0; s < settings.samples; ++s) {
            SampleDetail& sample = samples[static_cast<std::size_t>(s)];
            sample.before = before[s];
            sample.after = after[s];
            sample.of_fragment = raster::has_sample(fragment.coverage, s);
            sample.passed = raster::has_sample(fragment.passed, s);
        }
    }
    return samples;
}

} // namespace hs::trace
