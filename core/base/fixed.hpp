// Window positions in 24.8 fixed point: 8 fractional bits, as graphics hardware and Mesa have.
//
// Snapping makes coverage exact: two triangles that share an edge compute the very same integers
// along it.
#pragma once

#include <cmath>
#include <cstdint>

namespace hs {

inline constexpr int subpixel_bits = 8;
inline constexpr std::int32_t subpixel_scale = 1 << subpixel_bits;

/// The farthest a snapped coordinate may lie from the origin, in pixels: 2^22, so that raw
/// coordinates fit 31 bits and doubled areas 63. Beyond it a triangle gets a verdict instead of an
/// overflow.
inline constexpr float snap_limit = 4194304.0F; // 2^22

/// A snapped window coordinate relative to pixel *centers*: raw 0 is the center of pixel 0, raw 256
/// that of pixel 1.
struct FixedPosition {
    std::int32_t x = 0; ///< in 1/256 pixel
    std::int32_t y = 0; ///< in 1/256 pixel, down
    friend bool operator==(const FixedPosition&, const FixedPosition&) = default;
};

/// Rounds a window coordinate in pixels to 1/256 pixel, halves to even, after moving the origin to
/// a pixel center. Precondition: |coordinate| < snap_limit. Both steps before the rounding are
/// exact or correctly rounded in float, and `nearbyint` in the default rounding mode is what Mesa's
/// llvmpipe does.
[[nodiscard]] inline std::int32_t snap(float coordinate) {
    return static_cast<std::int32_t>(
        std::nearbyint((coordinate - 0.5F) * static_cast<float>(subpixel_scale))
    );
}

/// Back to pixels, exact for every snapped value within 2^15 pixels.
[[nodiscard]] inline float to_pixels(std::int32_t fixed) {
    return static_cast<float>(fixed) / static_cast<float>(subpixel_scale) + 0.5F;
}

} // namespace hs
