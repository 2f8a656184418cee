// Lines one pixel wide: from the pixel that holds one end to the pixel that holds the other, one
// pixel per column or, where the line is steep, per row.
//
// Both algorithms walk along the longer extent and decide at every pixel whether to move across it,
// too. They decide by the ideal line between the centers of the two end pixels.
#pragma once

#include "core/base/fixed.hpp"
#include "core/base/pixel.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace hs::raster {

/// The pixel whose square holds a snapped position; a position between two belongs to the right or
/// lower one.
[[nodiscard]] inline PixelPos pixel_of(const FixedPosition& p) {
    constexpr std::int32_t half = subpixel_scale / 2; // raw 0 is a pixel's center
    return {(p.x + half) >> subpixel_bits, (p.y + half) >> subpixel_bits};
}

struct LineSetup {
    FixedPosition from{};
    FixedPosition to{};
    PixelPos first{};
    PixelPos last{};
    int steps = 0;      ///< pixels along the longer extent, less one
    int rise = 0;       ///< pixels across it; 0 <= rise <= steps
    bool steep = false; ///< the longer extent is y
    int major_step = 1; ///< ±1
    int minor_step = 1; ///< ±1

    /// `k` steps along and `j` across from the first pixel.
    [[nodiscard]] PixelPos pixel(int k, int j) const {
        const int along = major_step * k;
        const int across = minor_step * j;
        return steep ? PixelPos{first.x + across, first.y + along}
                     : PixelPos{first.x + along, first.y + across};
    }
};

/// Precondition: both positions are snapped vertices.
[[nodiscard]] inline LineSetup set_up_line(const FixedPosition& from, const FixedPosition& to) {
    LineSetup line{.from = from, .to = to, .first = pixel_of(from), .last = pixel_of(to)};
    const int dx = line.last.x - line.first.x;
    const int dy = line.last.y - line.first.y;
    line.steep = std::abs(dy) > std::abs(dx);
    const int along = line.steep ? dy : dx;
    const int across = line.steep ? dx : dy;
    line.steps = std::abs(along);
    line.rise = std::abs(across);
    line.major_step = along < 0 ? -1 : 1;
    line.minor_step = across < 0 ? -1 : 1;
    return line;
}

/// One pixel of a line: the decision that led to it. Bresenham: the error term, a whole number.
/// DDA: the coordinate across the line, before rounding.
struct LineStep {
    int number = 0; ///< along the line, from 0
    PixelPos pixel{};
    bool moved = false;  ///< across the line, too
    double before = 0.0; ///< what was decided by
    double after = 0.0;  ///< what the next pixel is decided by
};

/// Steps along a line whose pixels can lie in a region: first … last, empty where last < first.
struct LineRange {
    int first = 0;
    int last = -1;
};

[[nodiscard]] inline LineRange steps_within(const LineSetup& line, const PixelRect& region) {
    const int start = line.steep ? line.first.y : line.first.x;
    const int low = line.steep ? region.y0 : region.x0;
    const int high = (line.steep ? region.y1 : region.x1) - 1;
    const int a = line.major_step * (low - start);
    const int b = line.major_step * (high - start);
    return {std::max(0, std::min(a, b)), std::min(line.steps, std::max(a, b))};
}

/// How far along the line a pixel's center lies: 0 at its first end, 1 at its last, by projection
/// onto it. Centers beyond an end get the end's values.
[[nodiscard]] inline float fraction_along(const LineSetup& line, PixelPos pixel) {
    const double dx = static_cast<double>(line.to.x) - line.from.x;
    const double dy = static_cast<double>(line.to.y) - line.from.y;
    const double length = dx * dx + dy * dy;
    if (length == 0.0) {
        return 0.0F;
    }
    const double x = static_cast<double>(pixel.x) * subpixel_scale - line.from.x;
    const double y = static_cast<double>(pixel.y) * subpixel_scale - line.from.y;
    return static_cast<float>(std::clamp((x * dx + y * dy) / length, 0.0, 1.0));
}

} // namespace hs::raster
