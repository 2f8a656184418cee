// An edge as scan conversion sees it: where it crosses each scanline, in exact integers.
//
// Foley, van Dam, Feiner and Hughes, Computer Graphics: Principles and Practice, 2nd edition, 1990,
// section 3.6. Differs: vertices at 1/256 pixel; scanlines run through pixel centers; x is kept as
// the first pixel whose center is not left of the edge and an exact remainder, so that spans
// [left, right) follow the top-left rule by themselves.
#pragma once

#include "core/raster/cost.hpp"
#include "core/raster/sample_pattern.hpp"
#include "core/raster/triangle_setup.hpp"

#include <array>
#include <cstdint>

namespace hs::raster {

/// One edge on one scanline. It crosses the scanline at exactly x − excess / denominator.
struct ScanEdge {
    int edge = 0;                 ///< 0, 1, 2: E01, E12, E20
    bool left = false;            ///< the interior lies to its right
    int first_row = 0;            ///< the first scanline it crosses inside the box
    int end_row = 0;              ///< one past the last; its lower end belongs to the next edge
    int x = 0;                    ///< the first pixel whose center is not left of the edge
    std::int64_t excess = 0;      ///< 0 … denominator − 1
    std::int64_t denominator = 1; ///< the edge's height in 1/65536 pixel
    std::int64_t step = 0;        ///< of x, per scanline
    std::int64_t step_excess = 0; ///< likewise, 0 … denominator − 1

    /// Where it crosses the scanline, for people and for sorting.
    [[nodiscard]] double position() const {
        return x - static_cast<double>(excess) / static_cast<double>(denominator);
    }
    /// How far it moves per scanline.
    [[nodiscard]] double slope() const {
        return static_cast<double>(step) -
               static_cast<double>(step_excess) / static_cast<double>(denominator);
    }
};

/// Edge k of a triangle on a scanline. Precondition: it is not horizontal and crosses that
/// scanline.
[[nodiscard]] ScanEdge scan_edge(const TriangleSetup& setup, int k, int row);

/// Moves to the next scanline; says what that cost: 2 additions, 4 if the remainder overflows.
Cost move_down(ScanEdge& edge);

/// What `scan_edge` costs: b·y + c, its quotient and that of the step.
inline constexpr Cost cost_of_scan_edge{.products = 1, .sums = 1, .divisions = 2};

/// The scanlines of the box that edge k crosses, [first, end); empty for a horizontal edge.
struct RowRange {
    int first = 0;
    int end = 0;
};
[[nodiscard]] RowRange rows_of_edge(const TriangleSetup& setup, int k);

/// The scanlines that pass through the triangle: those of the box but for one through its lowest
/// vertex.
[[nodiscard]] RowRange rows_of_triangle(const TriangleSetup& setup);

/// Where a scanline runs: through the pixel centers, or through one sample of every pixel. Then x
/// is that of the triangle moved so that the sample comes to lie on the center.
struct ScanPlace {
    int sample = -1; ///< −1: the centers
    SampleOffset offset;
};

/// Pixels between two edges of one scanline, [first, end), cut by the box. Empty if first >= end.
struct Span {
    int row = 0;
    int first = 0;
    int end = 0;
    ScanEdge left;
    ScanEdge right;
    ScanPlace place{};

    [[nodiscard]] int width() const { return first < end ? end - first : 0; }
};
[[nodiscard]] Span
span_between(const ScanEdge& left, const ScanEdge& right, int row, const PixelRect& box);

} // namespace hs::raster
