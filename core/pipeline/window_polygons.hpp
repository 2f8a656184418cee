// What list-priority algorithms order: every triangle as it will be seen in the window.
#pragma once

#include "core/pipeline/draw_order.hpp"

#include <cstdint>
#include <vector>

namespace hs::pipeline {

/// Whether a flat, convex face of the mesh is one polygon, or each of its triangles is.
enum class Faces : std::uint8_t {
    as_triangles,
    whole
};

struct WindowPolygons {
    std::vector<visibility::WindowPolygon> polygons;
    std::vector<Draw> unseen; ///< outside, culled, edge-on or without a place in the window
};

/// Clips against the view volume, divides and maps, in float as when a triangle is drawn. Depth
/// grows away from the eye: in the reversed convention it is one minus the stored depth. Weights
/// are divided by the corner's clip w, so that they are linear along edges in the window.
/// A face stays whole only if none of it is clipped or culled; it has no weights.
/// Precondition: the vertex stage has run.
WindowPolygons window_polygons(const Frame& frame, Faces faces = Faces::as_triangles);

} // namespace hs::pipeline
