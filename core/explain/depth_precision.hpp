// How a depth buffer spends its values between the near and the far plane, in closed form.
//
// Lengyel, "Projection Matrix Tricks" (GDC 2007), and Reed, "Depth Precision Visualized" (2015):
// stored depth is A + B/d, so steps of equal size in the buffer are steps of d²/B in distance.
#pragma once

#include "core/base/pixel.hpp"
#include "core/scene/camera.hpp"
#include "core/trace/recording.hpp"

#include <vector>

namespace hs::explain {

/// Stored depth as a function of the distance from the eye along the line of sight.
struct DepthCurve {
    double near = 0.1;
    double far = 10.0;
    bool perspective = true; ///< false: linear in the distance
    bool reversed = false;

    /// In [0, 1] between near and far.
    [[nodiscard]] double depth(double distance) const;
    /// The distance that has a depth; the inverse of `depth`.
    [[nodiscard]] double distance(double depth) const;
};

/// Of a scene's camera.
DepthCurve depth_curve(const scene::Camera& camera, scene::DepthConvention convention);

/// The step from a depth to the next value the format can store.
double depth_step(double depth, scene::DepthFormat format);

/// How far apart two surfaces at a distance must be to get different depths.
double resolved_distance(const DepthCurve& curve, double distance, scene::DepthFormat format);

/// The distance in front of which half of all values of a whole-number format lie.
double distance_of_half(const DepthCurve& curve);

/// Pixels in which the two nearest fragments are at most two steps apart: rounding decides which
/// is seen. In order of rows.
std::vector<PixelPos> fighting_pixels(const trace::Recording& recording);

} // namespace hs::explain
