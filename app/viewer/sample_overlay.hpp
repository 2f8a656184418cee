// Drawn over pixels that have several samples: where the samples lie, what they hold, and which of
// them the current triangle covers. And the helper pixels of its derivatives.
#pragma once

#include "app/viewer/panels.hpp"

#include <string>

namespace hs::viewer {

/// Every sample at its place in pixels that are large enough, filled with the color it holds; those
/// that the current triangle was asked about are ringed. Resolved pixels have none left to show.
void draw_sample_points(Context& context);

/// The pixels that are shaded only to help a neighbor of the current piece, while they are shown.
void draw_helper_pixels(Context& context);

/// "31 samples covered"; empty outside of traversals that ask samples.
std::string covered_samples_label(Context& context);

} // namespace hs::viewer
