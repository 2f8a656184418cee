// The order in which an eye sees the polygons of a BSP tree, from any point, without asking any
// polygon.
//
// Fuchs, Kedem and Naylor, 1980: what is on the eye's side of a plane cannot be hidden by what is
// on the other. Differs: a stack instead of recursion. At every node only the eye is classified.
#pragma once

#include "core/visibility/bsp.hpp"

#include <glm/vec4.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace hs::visibility {

/// Back to front to paint over, front to back to close what is written.
using WalkOrder = scene::BspOrder;

/// A node still to enter, or to emit between its two sides.
struct BspVisit {
    std::int32_t node = -1;
    Side side = Side::on; ///< of the parent's plane; `on`: the node's own polygons come now
    friend bool operator==(const BspVisit&, const BspVisit&) = default;
};

struct BspWalk {
    std::vector<BspVisit> stack; ///< the next one last
    std::vector<std::int32_t> order;
};

namespace bsp_walk_steps {

using Kind = OrderEventKind;

/// Decides on which side to go first; the node's own polygons come between.
template <OrderSink<BspWalk> Sink>
void enter(
    const BspTree& tree,
    std::int32_t index,
    const glm::dvec4& eye,
    WalkOrder walk_order,
    BspWalk& walk,
    Sink& sink
) {
    const BspNode& node = tree.nodes[static_cast<std::size_t>(index)];
    const double distance = signed_distance(node.plane, eye);
    const bool in_front = distance >= 0.0; // on the plane: it is seen edge-on, and either will do
    const BspVisit eye_side{in_front ? node.front : node.back, in_front ? Side::front : Side::back};
    const BspVisit far_side{in_front ? node.back : node.front, in_front ? Side::back : Side::front};
    const bool far_first = walk_order == WalkOrder::back_to_front;
    const BspVisit& first = far_first ? far_side : eye_side;
    const BspVisit& last = far_first ? eye_side : far_side;
    if (last.node >= 0) {
        walk.stack.push_back(last);
    }
    walk.stack.push_back({index, Side::on});
    if (first.node >= 0) {
        walk.stack.push_back(first);
    }
    const double length = glm::length(node.plane.normal); // 0 only for a polygon without area
    sink.order_step(
        {.kind = Kind::enter_node,
         .verdict = in_front,
         .node = index,
         .value = length > 0.0 ? distance / length : 0.0},
        walk
    );
}

/// Those of one plane: the first of the file is to be seen, so it is painted last, or written
/// first.
[[nodiscard]] inline std::vector<std::int32_t>
own_polygons(const BspTree& tree, std::int32_t node, WalkOrder walk_order) {
    std::vector<std::int32_t> own = tree.nodes[static_cast<std::size_t>(node)].polygons;
    std::ranges::stable_sort(own, {}, [&](std::int32_t i) { return tree.set.polygon(i).triangle; });
    if (walk_order == WalkOrder::back_to_front) {
        std::ranges::reverse(own);
    }
    return own;
}

template <OrderSink<BspWalk> Sink>
void emit(BspWalk& walk, std::int32_t polygon, std::int32_t node, Sink& sink) {
    walk.order.push_back(polygon);
    sink.order_step(
        {.kind = Kind::emit,
         .polygon = polygon,
         .node = node,
         .place = static_cast<std::int32_t>(walk.order.size()) - 1},
        walk
    );
}

} // namespace bsp_walk_steps

/// `eye` in world space; w = 0: the direction toward it, infinitely far away.
template <OrderSink<BspWalk> Sink>
[[nodiscard]] BspWalk
walk_bsp(const BspTree& tree, const glm::dvec4& eye, WalkOrder walk_order, Sink& sink) {
    namespace steps = bsp_walk_steps;
    BspWalk walk;
    if (!tree.nodes.empty()) {
        walk.stack.push_back({0, Side::front});
    }
    while (!walk.stack.empty()) {
        const BspVisit visit = walk.stack.back();
        walk.stack.pop_back();
        if (visit.side != Side::on) {
            const std::int32_t parent = tree.nodes[static_cast<std::size_t>(visit.node)].parent;
            if (parent >= 0) {
                sink.order_step(
                    {.kind = OrderEventKind::visit_side, .side = visit.side, .node = parent}, walk
                );
            }
            steps::enter(tree, visit.node, eye, walk_order, walk, sink);
            continue;
        }
        for (const std::int32_t polygon : steps::own_polygons(tree, visit.node, walk_order)) {
            steps::emit(walk, polygon, visit.node, sink);
        }
    }
    return walk;
}

} // namespace hs::visibility
