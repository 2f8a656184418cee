// Pixel addresses. Pixels count from the top-left pixel (0, 0), x to the right, y down, wherever
// people or files meet them.
#pragma once

#include <algorithm>
#include <compare>

namespace hs {

/// A cell of the framebuffer; its center lies at (x + 0.5, y + 0.5) in window coordinates.
struct PixelPos {
    int x = 0;
    int y = 0;
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 misreads a defaulted comparison
    friend auto operator<=>(const PixelPos&, const PixelPos&) = default;
};

/// Pixels with x in [x0, x1) and y in [y0, y1). Empty when x1 <= x0 or y1 <= y0.
struct PixelRect {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;

    [[nodiscard]] int width() const { return std::max(0, x1 - x0); }
    [[nodiscard]] int height() const { return std::max(0, y1 - y0); }
    [[nodiscard]] bool empty() const { return x1 <= x0 || y1 <= y0; }
    [[nodiscard]] bool contains(PixelPos p) const {
        return p.x >= x0 && p.x < x1 && p.y >= y0 && p.y < y1;
    }
    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

[[nodiscard]] inline PixelRect intersect(const PixelRect& a, const PixelRect& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

} // namespace hs
