// The choice of a traversal by settings: one combo box and one property test serve them all.
#pragma once

#include "core/base/check.hpp"
#include "core/raster/bounding_box.hpp"
#include "core/raster/brute_force.hpp"

namespace hs::raster {

template <TraversalTrace Trace, typename Emit>
void traverse(
    scene::TraversalKind kind,
    const TriangleSetup& setup,
    const PixelRect& image,
    UnitRange units,
    Trace& trace,
    Emit&& emit
) {
    switch (kind) {
    case scene::TraversalKind::brute_force:
        return traverse_brute_force(setup, image, units, trace, emit);
    case scene::TraversalKind::bounding_box:
        return traverse_bounding_box(setup, image, units, trace, emit);
    }
    HS_CHECK(false, "every traversal is handled");
}

} // namespace hs::raster
