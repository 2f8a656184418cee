#include "core/raster/scan_edge.hpp"

#include "core/base/check.hpp"

#include <algorithm>

namespace hs::raster {
namespace {

/// The quotient rounded up, and what must be subtracted to return: value = quotient·d − rest.
struct RoundedUp {
    std::int64_t quotient = 0;
    std::int64_t rest = 0; ///< 0 … d − 1
};

RoundedUp divide_up(std::int64_t value, std::int64_t d) {
    std::int64_t quotient = value / d; // toward zero
    if (quotient * d < value) {
        ++quotient;
    }
    return {quotient, quotient * d - value};
}

} // namespace

ScanEdge scan_edge(const TriangleSetup& setup, int k, int row) {
    const EdgeFunction& e = setup.edges[static_cast<unsigned>(k)];
    HS_DCHECK(e.a != 0, "a horizontal edge crosses no scanline");
    const std::int64_t sign = e.a > 0 ? 1 : -1;
    ScanEdge edge;
    edge.edge = k;
    edge.left = e.a > 0;
    const RowRange rows = rows_of_edge(setup, k);
    edge.first_row = rows.first;
    edge.end_row = rows.end;

    // E = 0 at x = −(b·y + c) / a
    edge.denominator = sign * e.a * subpixel_scale;
    const std::int64_t y = std::int64_t{row} * subpixel_scale;
    const RoundedUp x = divide_up(-sign * (e.b * y + e.c), edge.denominator);
    edge.x = static_cast<int>(x.quotient);
    edge.excess = x.rest;

    // One scanline down adds −b / a
    const RoundedUp step = divide_up(-sign * e.b * subpixel_scale, edge.denominator);
    edge.step = step.quotient;
    edge.step_excess = step.rest;
    return edge;
}

Cost move_down(ScanEdge& edge) {
    edge.x += static_cast<int>(edge.step);
    edge.excess += edge.step_excess;
    if (edge.excess < edge.denominator) {
        return {.sums = 2};
    }
    --edge.x;
    edge.excess -= edge.denominator;
    return {.sums = 4};
}

RowRange rows_of_edge(const TriangleSetup& setup, int k) {
    const std::int32_t from = setup.vertices[static_cast<unsigned>(k)].y;
    const std::int32_t to = setup.vertices[static_cast<unsigned>((k + 1) % 3)].y;
    return {
        std::max(first_center_at_or_after(std::min(from, to)), setup.bounds.y0),
        std::min(first_center_at_or_after(std::max(from, to)), setup.bounds.y1)};
}

RowRange rows_of_triangle(const TriangleSetup& setup) {
    const auto& v = setup.vertices;
    const std::int32_t lowest = std::max({v[0].y, v[1].y, v[2].y});
    return {setup.bounds.y0, std::min(first_center_at_or_after(lowest), setup.bounds.y1)};
}

Span span_between(const ScanEdge& left, const ScanEdge& right, int row, const PixelRect& box) {
    return {row, std::max(left.x, box.x0), std::min(right.x, box.x1), left, right};
}

} // namespace hs::raster
