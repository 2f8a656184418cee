// Filling a span: its pixels are known to be covered, so none is asked.
#pragma once

#include "core/raster/edge_steps.hpp"
#include "core/raster/scan_edge.hpp"
#include "core/raster/traversal.hpp"

namespace hs::raster {

/// Narrates the span and emits its pixels. The edge functions are evaluated at its first pixel and
/// moved from there: they are what weights, and so depth and varyings, are made of.
template <TraversalTrace Trace, typename Emit>
void fill_span(
    const TriangleSetup& setup, const EdgeSteps& steps, const Span& span, Trace& trace, Emit&& emit
) {
    trace.span_found(span);
    if (span.width() == 0) {
        return;
    }
    EdgeValues values = setup.evaluate({span.first, span.row});
    trace.cost({.evaluations = 3});
    for (int x = span.first; x < span.end; ++x) {
        trace.cost({.pixels = 1});
        emit(PixelPos{x, span.row}, values);
        move(values, steps.right);
        trace.cost(cost_of_moving);
    }
}

} // namespace hs::raster
