// The choice of a traversal by settings: one combo box and one property test serve them all.
#pragma once

#include "core/base/check.hpp"
#include "core/raster/bounding_box.hpp"
#include "core/raster/brute_force.hpp"
#include "core/raster/edge_table.hpp"
#include "core/raster/edge_walk.hpp"
#include "core/raster/hierarchical.hpp"
#include "core/raster/homogeneous.hpp"
#include "core/raster/incremental.hpp"
#include "core/raster/sample_spans.hpp"
#include "core/raster/serpentine.hpp"

#include <concepts>

namespace hs::raster {

/// What the settings choose.
struct TraversalChoice {
    scene::TraversalKind kind = scene::TraversalKind::bounding_box;
    int tile_size = 8; ///< hierarchical: a power of two
};

/// `emit` is what the setup asks for: of pixels (pixel, edge values), of a `SampledSetup`'s samples
/// (pixel, edge values at its center, covered samples).
template <std::derived_from<TriangleSetup> Setup, TraversalTrace Trace, typename Emit>
void traverse(
    const TraversalChoice& choice,
    const Setup& setup,
    const PixelRect& image,
    UnitRange units,
    Trace& trace,
    Emit&& emit
) {
    if constexpr (requires { requires Trace::ignores_traversal; }) {
        return traverse_bounding_box(setup, image, units, trace, emit); // the fastest here
    }
    switch (choice.kind) {
    case scene::TraversalKind::brute_force:
        return traverse_brute_force(setup, image, units, trace, emit);
    case scene::TraversalKind::bounding_box:
        return traverse_bounding_box(setup, image, units, trace, emit);
    case scene::TraversalKind::incremental:
        return traverse_incremental(setup, image, units, trace, emit);
    case scene::TraversalKind::serpentine:
        return traverse_serpentine(setup, image, units, trace, emit);
    case scene::TraversalKind::hierarchical:
        return traverse_hierarchical(choice.tile_size, setup, image, units, trace, emit);
    case scene::TraversalKind::edge_walk:
        return traverse_edge_walk(setup, image, units, trace, emit);
    case scene::TraversalKind::edge_table:
        return traverse_edge_table(setup, image, units, trace, emit);
    case scene::TraversalKind::homogeneous:
        if constexpr (std::same_as<Setup, TriangleSetup>) {
            return traverse_homogeneous(setup, image, units, trace, emit);
        }
        break;
    }
    HS_CHECK(false, "every traversal is handled; samples have no homogeneous one");
}

} // namespace hs::raster
