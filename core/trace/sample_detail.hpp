// What a triangle does at each sample of one pixel: the table behind a step of a frame with several
// samples a pixel.
#pragma once

#include "core/framebuffer/samples.hpp"
#include "core/raster/sample_pattern.hpp"
#include "core/raster/triangle_setup.hpp"
#include "core/trace/recording.hpp"
#include "core/trace/step.hpp"

#include <array>
#include <vector>

namespace hs::trace {

/// One sample of a pixel, as one piece of a triangle meets it.
struct SampleDetail {
    raster::SampleOffset offset;
    raster::EdgeValues edges{}; ///< E01, E12, E20 at the sample
    bool covered = false;
    float depth = 0.0F;              ///< the piece's there, as its format stores it
    framebuffer::SampleValue before; ///< fragment steps: what the sample held
    framebuffer::SampleValue after;  ///< fragment steps: what the fragment leaves there
    bool of_fragment = false;        ///< fragment steps: the fragment stands for this sample
    bool passed = false;             ///< fragment steps: and passed every test there
};

/// Of the step's pixel. `setup` and `window` are the step's piece.
std::vector<SampleDetail> samples_of_piece(
    const Recording& recording,
    const raster::TriangleSetup& setup,
    const std::array<geometry::WindowVertex, 3>& window,
    const Step& step
);

} // namespace hs::trace
