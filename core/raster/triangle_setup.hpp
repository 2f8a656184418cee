// Triangle setup: everything about a triangle that does not depend on the pixel.
#pragma once

#include "core/base/fixed.hpp"
#include "core/base/pixel.hpp"
#include "core/raster/edge_function.hpp"

#include <array>
#include <cstdint>

namespace hs::raster {

/// The first pixel whose center is not left of (above) a snapped coordinate. Arithmetic shift
/// rounds toward −infinity.
[[nodiscard]] inline int first_center_at_or_after(std::int32_t fixed) {
    return static_cast<int>((std::int64_t{fixed} + (subpixel_scale - 1)) >> subpixel_bits);
}

/// One past the last pixel whose center is not right of (below) a snapped coordinate.
[[nodiscard]] inline int end_of_centers_up_to(std::int32_t fixed) {
    return static_cast<int>((std::int64_t{fixed} >> subpixel_bits) + 1);
}

struct TriangleSetup {
    std::array<FixedPosition, 3> vertices{};
    std::array<EdgeFunction, 3>
        edges{}; ///< E01, E12, E20: edge k runs from vertex k to vertex k + 1
    /// 0 for an edge that owns its ties, −1 for one that does not: a pixel is covered iff E + bias
    /// >= 0 on all three. (Conservative overlap keeps another constant here: conservative.hpp.)
    std::array<std::int64_t, 3> top_left_bias{};
    std::int64_t doubled_area =
        0; ///< > 0, in 1/65536 pixel²; the sum of the three edge functions anywhere
    float inv_doubled_area = 0.0F;
    PixelRect bounds; ///< pixels whose centers can be covered, clipped to the image

    [[nodiscard]] EdgeValues evaluate(PixelPos p) const {
        return {edges[0](p), edges[1](p), edges[2](p)};
    }
    [[nodiscard]] bool covers(const EdgeValues& e) const {
        const std::int64_t e0 = e[0] + top_left_bias[0];
        const std::int64_t e1 = e[1] + top_left_bias[1];
        const std::int64_t e2 = e[2] + top_left_bias[2];
        return (e0 | e1 | e2) >= 0; // the sign bit of any is the sign bit of all three together
    }
};

/// Precondition: the snapped vertices enclose an area; `signed_doubled_area` is theirs. `image`
/// limits the bounds.
TriangleSetup set_up(
    const std::array<FixedPosition, 3>& vertices,
    std::int64_t signed_doubled_area,
    const PixelRect& image
);

} // namespace hs::raster
