// The depth buffer's formats, and the depth a fragment is tested with.
//
// OpenGL 4.6, sections 2.3.5 (fixed-point data conversions) and 17.3.6 (depth buffer test).
#pragma once

#include "core/scene/settings.hpp"

#include <cmath>

namespace hs::framebuffer {

/// Clamps to [0, 1] and rounds to the nearest value the format can store: n / (2^bits − 1). Every
/// such value is held as a float of its own, so that comparing floats compares the stored integers.
[[nodiscard]] inline float store_depth(float depth, scene::DepthFormat format) {
    const float clamped = !(depth > 0.0F) ? 0.0F : depth >= 1.0F ? 1.0F : depth; // NaN becomes 0
    if (format == scene::DepthFormat::float32) {
        return clamped;
    }
    const double steps = format == scene::DepthFormat::unorm24 ? 16777215.0 : 65535.0;
    return static_cast<float>(std::floor(static_cast<double>(clamped) * steps + 0.5) / steps);
}

} // namespace hs::framebuffer
