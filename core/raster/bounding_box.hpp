// Bounding box: ask the pixels between the triangle's outermost vertices, clipped to the image.
// Cost: the box's area; a thin diagonal triangle wastes nearly all of it.
#pragma once

#include "core/raster/traversal.hpp"

#include <concepts>

namespace hs::raster {

template <std::derived_from<TriangleSetup> Setup, TraversalTrace Trace, typename Emit>
void traverse_bounding_box(
    const Setup& setup, const PixelRect& /*image*/, UnitRange units, Trace& trace, Emit&& emit
) {
    visit_rows(setup, setup.bounds, units, trace, emit); // the bounds lie inside the image already
}

} // namespace hs::raster
