// Visibility ordering: which triangles are drawn when. Stands between the vertex stage and those
// that every triangle goes through by itself, because it needs all triangles at once.
//
// Algorithms in the window draw back to front. Those in the world build a tree first, which does
// not depend on the eye, and walk it then.
#pragma once

#include "core/pipeline/draw_order.hpp"
#include "core/pipeline/window_polygons.hpp"
#include "core/pipeline/world_polygons.hpp"
#include "core/visibility/bsp_walk.hpp"
#include "core/visibility/depth_sort.hpp"
#include "core/visibility/front_lists.hpp"
#include "core/visibility/octree_walk.hpp"
#include "core/visibility/painters.hpp"

#include <utility>

namespace hs::pipeline {

/// Listens to every algorithm that orders triangles.
template <typename Sink>
concept AnyOrderSink = visibility::OrderSink<Sink, visibility::PaintersSort> &&
    visibility::OrderSink<Sink, visibility::FrontLists> &&
    visibility::OrderSink<Sink, visibility::DepthSort> &&
    visibility::OrderSink<Sink, visibility::BspTree> &&
    visibility::OrderSink<Sink, visibility::BspWalk> &&
    visibility::OrderSink<Sink, visibility::Octree> &&
    visibility::OrderSink<Sink, visibility::OctreeWalk>;

[[nodiscard]] inline visibility::BspOptions bsp_options(const scene::Settings& settings) {
    return {.splitter = settings.bsp_splitter, .seed = settings.bsp_seed};
}

template <AnyOrderSink Sink>
visibility::BspTree build_tree(const Frame& frame, Sink& sink) {
    return visibility::build_bsp(world_polygons(frame), bsp_options(frame.settings()), sink);
}

template <AnyOrderSink Sink>
visibility::BspWalk walk_tree(const Frame& frame, const visibility::BspTree& tree, Sink& sink) {
    return visibility::walk_bsp(tree, eye_in_world(frame), frame.settings().bsp_order, sink);
}

/// A cell is divided while it holds more than one polygon. Where triangles cross or touch none is
/// small enough to part them, and every level has twice to four times as many cells along them:
/// only a handful of triangles gets cells smaller than a pixel.
[[nodiscard]] inline visibility::OctreeOptions octree_options(std::size_t triangles) {
    constexpr std::size_t handful = 8;
    constexpr std::size_t hundreds = 512;
    return {
        .occupancy = triangles <= hundreds ? 1 : 4,
        .depth = triangles <= handful    ? 8
                 : triangles <= hundreds ? 4
                                         : 6};
}

template <AnyOrderSink Sink>
visibility::Octree build_cells(const Frame& frame, Sink& sink) {
    std::vector<visibility::WorldPolygon> polygons = world_polygons(frame);
    const visibility::OctreeOptions options = octree_options(polygons.size());
    return visibility::build_octree(std::move(polygons), options, sink);
}

template <AnyOrderSink Sink>
visibility::OctreeWalk walk_cells(const Frame& frame, const visibility::Octree& tree, Sink& sink) {
    return visibility::walk_octree(tree, eye_in_world(frame), sink);
}

/// In the window, back to front.
template <AnyOrderSink Sink>
DrawOrder order_in_window(const Frame& frame, Sink& sink) {
    const scene::Settings& settings = frame.settings();
    if (settings.visibility == scene::Visibility::front_lists) {
        WindowPolygons window = window_polygons(frame, Faces::whole);
        const visibility::FrontLists lists =
            visibility::order_by_front_lists(std::move(window.polygons), sink);
        return draw_order(frame, lists.polygons, {lists.order, lists.stuck, window.unseen});
    }
    WindowPolygons window = window_polygons(frame);
    if (settings.visibility == scene::Visibility::newell_sancha) {
        const visibility::DepthSort sort =
            visibility::sort_by_depth(std::move(window.polygons), sink);
        return draw_order(frame, sort.set.polygons, {sort.order, {}, window.unseen});
    }
    const visibility::PaintersSort sort =
        visibility::sort_painters(std::move(window.polygons), settings.painters_key, sink);
    return draw_order(frame, sort.polygons, {sort.order, {}, window.unseen});
}

/// Runs the algorithm that the settings choose; z-buffer and none leave triangles in file order,
/// scanlines and rays come after all of them.
/// Precondition: the vertex stage has run, and `refuse_order` has no complaint.
template <AnyOrderSink Sink>
DrawOrder order_triangles(const Frame& frame, Sink& sink) {
    const scene::Settings& settings = frame.settings();
    if (settings.sweeps()) {
        return rows_after_triangles(frame);
    }
    if (!settings.orders_triangles()) {
        return file_order(frame);
    }
    if (settings.visibility == scene::Visibility::bsp) {
        const visibility::BspTree tree = build_tree(frame, sink);
        const visibility::BspWalk walk = walk_tree(frame, tree, sink);
        return draw_order(frame, tree.set.polygons, {walk.order, {}, {}});
    }
    if (settings.visibility == scene::Visibility::octree) {
        const visibility::Octree tree = build_cells(frame, sink);
        const visibility::OctreeWalk walk = walk_cells(frame, tree, sink);
        return draw_order(frame, tree.set.polygons, {walk.order, {}, {}});
    }
    return order_in_window(frame, sink);
}

} // namespace hs::pipeline
