// Visibility ordering: which triangles are drawn when. Stands between the vertex stage and those
// that every triangle goes through by itself, because it needs all triangles at once.
#pragma once

#include "core/pipeline/draw_order.hpp"
#include "core/pipeline/window_polygons.hpp"
#include "core/visibility/painters.hpp"

#include <utility>

namespace hs::pipeline {

/// Listens to every algorithm that orders triangles.
template <typename Sink>
concept AnyOrderSink = visibility::OrderSink<Sink, visibility::PaintersSort>;

/// Runs the algorithm that the settings choose; none leaves triangles in file order.
/// Precondition: the vertex stage has run.
template <AnyOrderSink Sink>
DrawOrder order_triangles(const Frame& frame, Sink& sink) {
    const scene::Settings& settings = frame.settings();
    if (!settings.orders_triangles()) {
        return file_order(frame);
    }
    WindowPolygons window = window_polygons(frame);
    const visibility::PaintersSort sort =
        visibility::sort_painters(std::move(window.polygons), settings.painters_key, sink);
    return draw_order(frame, sort.polygons, sort.order, window.unseen);
}

} // namespace hs::pipeline
