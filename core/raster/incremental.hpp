// Incremental: the pixels of the bounding box, each edge value reached from its neighbor's by one
// addition. Two sets of registers: the values at the pixel, and those at the beginning of the row.
//
// Pineda, A Parallel Algorithm for Polygon Rasterization, 1988. Cost: one evaluation of the three
// edge functions per triangle, three additions per pixel and three per row.
#pragma once

#include "core/raster/edge_steps.hpp"
#include "core/raster/traversal.hpp"

#include <concepts>

namespace hs::raster {

template <std::derived_from<TriangleSetup> Setup, TraversalTrace Trace, typename Emit>
void traverse_incremental(
    const Setup& setup, const PixelRect& /*image*/, UnitRange units, Trace& trace, Emit&& emit
) {
    const PixelRect& box = setup.bounds;
    if (box.empty()) {
        return;
    }
    const EdgeSteps steps = edge_steps(setup);
    const int last = std::min(units.last, box.height());
    EdgeValues row = setup.evaluate({box.x0, box.y0 + units.first});
    for (int unit = units.first; unit < last; ++unit) {
        trace.unit(unit);
        if (unit == 0) {
            trace.cost({.evaluations = 3});
        }
        EdgeValues values = row;
        for (int x = box.x0; x < box.x1; ++x) {
            trace.cost({.pixels = 1});
            ask(setup, {x, box.y0 + unit}, values, trace, emit);
            move(values, steps.right); // after the test: before it, every pixel asks its neighbor
            trace.cost(cost_of_moving);
        }
        move(row, steps.down);
        trace.cost(cost_of_moving);
    }
}

} // namespace hs::raster
