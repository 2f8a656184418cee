// Serpentine: the bounding box in a zig-zag, one row to the right, the next one to the left. Every
// pixel is next to the one before, so one set of registers is enough: no row to return to.
//
// Pineda, A Parallel Algorithm for Polygon Rasterization, 1988, section 4. Differs: rows run
// through the whole box, as every row must be a place to resume at. Cost: one evaluation of the
// three edge functions per triangle, three additions per pixel.
#pragma once

#include "core/raster/edge_steps.hpp"
#include "core/raster/traversal.hpp"

#include <concepts>

namespace hs::raster {

template <std::derived_from<TriangleSetup> Setup, TraversalTrace Trace, typename Emit>
void traverse_serpentine(
    const Setup& setup, const PixelRect& /*image*/, UnitRange units, Trace& trace, Emit&& emit
) {
    const PixelRect& box = setup.bounds;
    if (box.empty()) {
        return;
    }
    const EdgeSteps steps = edge_steps(setup);
    const int last = std::min(units.last, box.height());
    PixelPos pixel{units.first % 2 == 0 ? box.x0 : box.x1 - 1, box.y0 + units.first};
    EdgeValues values = setup.evaluate(pixel);
    for (int unit = units.first; unit < last; ++unit) {
        trace.unit(unit);
        if (unit == 0) {
            trace.cost({.evaluations = 3});
        }
        for (int visited = 0; visited < box.width(); ++visited) {
            trace.cost({.pixels = 1});
            ask(setup, pixel, values, trace, emit);
            if (visited + 1 == box.width()) {
                move(values, steps.down);
                ++pixel.y;
            } else if (unit % 2 == 0) {
                move(values, steps.right);
                ++pixel.x;
            } else {
                move_back(values, steps.right);
                --pixel.x;
            }
            trace.cost(cost_of_moving);
        }
    }
}

} // namespace hs::raster
