// What list-priority algorithms order: every triangle as it will be seen in the window.
#pragma once

#include "core/pipeline/draw_order.hpp"

#include <vector>

namespace hs::pipeline {

struct WindowPolygons {
    std::vector<visibility::WindowPolygon> polygons;
    std::vector<Draw> unseen; ///< outside, culled, edge-on or without a place in the window
};

/// Clips against the view volume, divides and maps, in float as when a triangle is drawn. Depth
/// grows away from the eye: in the reversed convention it is one minus the stored depth. Weights
/// are divided by the corner's clip w, so that they are linear along edges in the window.
/// Precondition: the vertex stage has run.
WindowPolygons window_polygons(const Frame& frame);

} // namespace hs::pipeline
