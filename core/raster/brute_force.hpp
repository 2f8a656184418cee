// Brute force: ask every pixel of the image. Cost: the image's area, whatever the triangle's.
#pragma once

#include "core/raster/traversal.hpp"

#include <concepts>

namespace hs::raster {

template <std::derived_from<TriangleSetup> Setup, TraversalTrace Trace, typename Emit>
void traverse_brute_force(
    const Setup& setup, const PixelRect& image, UnitRange units, Trace& trace, Emit&& emit
) {
    visit_rows(setup, image, units, trace, emit);
}

} // namespace hs::raster
