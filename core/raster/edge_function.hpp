// Pineda, A Parallel Algorithm for Polygon Rasterization, 1988.
//
// Differs: exact integers in 24.8 fixed point; positive inside whatever the winding (a triangle
// with negative area has its three functions negated); ties by the top-left rule (Direct3D 11
// functional specification, section 3.4).
#pragma once

#include "core/base/fixed.hpp"
#include "core/base/pixel.hpp"

#include <array>
#include <cstdint>

namespace hs::raster {

/// a·x + b·y + c for the line from one snapped vertex to the next, x and y in 1/256 pixel from the
/// center of pixel (0, 0). Values are in 1/65536 pixel²: twice the area of the triangle that the
/// point makes with the edge.
struct EdgeFunction {
    std::int64_t a = 0;
    std::int64_t b = 0;
    std::int64_t c = 0;

    /// At a pixel's center. |value| < 2^62 for every pixel of an image up to 8192².
    [[nodiscard]] std::int64_t operator()(PixelPos p) const {
        return a * (std::int64_t{p.x} * subpixel_scale) + b * (std::int64_t{p.y} * subpixel_scale) +
               c;
    }

    /// Top and left edges own the pixel centers that lie exactly on them: left edges have the
    /// interior to their right (a > 0), top edges are horizontal with the interior below (a = 0, b
    /// > 0).
    [[nodiscard]] bool owns_ties() const { return a > 0 || (a == 0 && b > 0); }

    friend bool operator==(const EdgeFunction&, const EdgeFunction&) = default;
};

[[nodiscard]] inline EdgeFunction
edge_through(const FixedPosition& from, const FixedPosition& to, bool negate) {
    const std::int64_t sign = negate ? -1 : 1;
    const std::int64_t a = sign * (std::int64_t{to.y} - from.y);
    const std::int64_t b = -sign * (std::int64_t{to.x} - from.x);
    return {a, b, -(a * from.x + b * from.y)};
}

/// E01, E12, E20 at one pixel.
using EdgeValues = std::array<std::int64_t, 3>;

} // namespace hs::raster
