// Moving edge values to a neighboring pixel: E(x + 1, y) = E(x, y) + a, E(x, y + 1) = E(x, y) + b.
//
// Pineda, A Parallel Algorithm for Polygon Rasterization, 1988. Exact in integers, so a value
// reached by steps equals the value evaluated afresh.
#pragma once

#include "core/raster/triangle_setup.hpp"

namespace hs::raster {

/// What one pixel to the right and one pixel down add to E01, E12, E20.
struct EdgeSteps {
    EdgeValues right{};
    EdgeValues down{};
};

[[nodiscard]] inline EdgeSteps edge_steps(const TriangleSetup& setup) {
    EdgeSteps steps;
    for (unsigned k = 0; k < 3; ++k) {
        steps.right[k] = setup.edges[k].a * subpixel_scale;
        steps.down[k] = setup.edges[k].b * subpixel_scale;
    }
    return steps;
}

inline void move(EdgeValues& values, const EdgeValues& by) {
    for (unsigned k = 0; k < 3; ++k) {
        values[k] += by[k];
    }
}

inline void move_back(EdgeValues& values, const EdgeValues& by) {
    for (unsigned k = 0; k < 3; ++k) {
        values[k] -= by[k];
    }
}

} // namespace hs::raster
