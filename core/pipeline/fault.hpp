// Seeded faults: classic mistakes that `settings.fault` switches on, for bug hunts in lessons and
// to prove that the tests see them. Everything wrong is in this room's two functions and in the two
// choices of a viewport (snapping, divide); the pipeline itself knows no fault.
#pragma once

#include "core/pipeline/frame.hpp"
#include "core/raster/conservative.hpp"
#include "core/raster/sample_coverage.hpp"
#include "core/raster/triangle_setup.hpp"

namespace hs::pipeline {

/// Spoils what a draw call is made ready with: matrices, clip volume, viewport, state.
void seed_fault(DrawCall& call);

/// Spoils edge functions or the ownership of ties.
void seed_fault(scene::Fault fault, raster::TriangleSetup& setup);

/// Setup: edge functions of a triangle in the window, within `region` of it, for the points or
/// pixels that the sampling asks.
[[nodiscard]] inline raster::TriangleSetup set_up_edges(
    const DrawCall& call,
    const std::array<FixedPosition, 3>& vertices,
    std::int64_t doubled_area,
    const PixelRect& region
) {
    raster::TriangleSetup setup = raster::set_up(vertices, doubled_area, region);
    if (call.settings.fault != scene::Fault::none) {
        seed_fault(call.settings.fault, setup);
    }
    if (call.settings.samples > 1) {
        setup.bounds = raster::bounds_of_samples(setup, call.settings.samples, region);
    } else if (call.settings.sampling == scene::Sampling::conservative) {
        raster::widen_to_squares(setup, region);
    }
    return setup;
}

} // namespace hs::pipeline
