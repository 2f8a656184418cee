// How an ordering algorithm tells its story: one event per decision, and the state after it.
#pragma once

#include "core/visibility/side.hpp"

#include <concepts>
#include <cstdint>

namespace hs::visibility {

/// A decision. What the numbers mean is said beside each kind; `polygon` and `other` are indices
/// into the polygons of the state.
enum class OrderEventKind : std::uint8_t {
    // All lists
    compare, ///< is the key of `polygon` (`value`) before that of `other` (`other_value`)?
    move,    ///< `polygon` goes to place `place` of the list; because of `other`, if there is one
    emit,    ///< `polygon` is drawn next, as number `place`

    // Front lists
    overlap,       ///< do the projections of `polygon` and `other` overlap?
    nearer,        ///< where they overlap, is `polygon` (depth `value`) in front of `other`
                   ///< (`other_value`)? No verdict and equal depths: neither is
    list_in_front, ///< `other` enters the front list of `polygon` at `place`; `value` polygons
                   ///< behind `other` so far
    iteration,     ///< iteration `place` begins: the counter of `value` polygons is 0
    count_down,    ///< `other` was drawn: `polygon` has `value` undrawn polygons behind it
    stuck, ///< no counter is 0: `polygon` can never be drawn. Verdict: it is part of a cycle or
           ///< between two, not merely in front of one

    // Newell, Newell and Sancha
    take_farthest, ///< `polygon`, farthest depth `value`, is P, with `place` polygons drawn
    test, ///< does test `place` (`NewellTest`) show that P = `polygon` may be drawn before Q =
          ///< `other`? `value` and `other_value`: extents (0: nearest depth of P, farthest of Q; 1,
          ///< 2: gap between the extents); 3, 4: `side` of the tested polygon
    exchanged_test, ///< test 3 or 4 in exchanged roles: may `polygon` (Q) be drawn before `other`
                    ///< (P)? Numbers as for `test`
    draw_anyway,    ///< a cycle that no plane cuts, by rounding: `polygon` is drawn before `other`

    // Splitting, in any algorithm that splits
    split, ///< the plane of `other` (-1: the wall of cell `node` across axis `axis`) cuts
           ///< `polygon`, which keeps the part in front; the part behind becomes polygon `place`.
           ///< `value`, `other_value`: areas of the two

    // BSP tree
    candidate,  ///< the plane of `polygon` would split `value` of the `other_value` polygons of
                ///< the list of node `node`. Verdict: the best so far
    make_node,  ///< `polygon` becomes the splitter of node `node`, child of node `place` (-1: the
                ///< root) on `side`, for a list of `value` polygons
    classify,   ///< `polygon` lies on `side` of the plane of node `node`
    enter_node, ///< the walk comes to node `node`. Verdict: the eye is in its front half-space, at
                ///< signed distance `value`
    visit_side, ///< the walk goes on on `side` of node `node`

    // Octree
    make_cell,  ///< cell `node`, child of cell `place` (-1: the root), holds `value` polygons.
                ///< Verdict: it is divided
    enter_cell, ///< the walk comes to cell `node`, `value` polygons. Verdict: it is a leaf
    in_front,   ///< polygons of one leaf: do the planes show that `polygon` is in front of `other`?
    undecided,  ///< no polygon left in leaf `node` is in front of all others: the one with the
                ///< nearest center, `polygon`, is taken before `other`
};

/// Newell, Newell and Sancha's tests, cheapest first: `place` of the events `test` and
/// `exchanged_test`.
enum class NewellTest : std::uint8_t {
    depth_extents,     ///< 0: no point of Q is farther than a point of P
    x_extents,         ///< 1: the x extents do not overlap
    y_extents,         ///< 2: nor the y extents
    behind_plane,      ///< 3: P is wholly behind Q's plane, as seen from the eye
    in_front_of_plane, ///< 4: Q is wholly on the eye's side of P's plane
    projections,       ///< 5: the projections do not overlap
};

/// One step of an ordering algorithm.
struct OrderEvent {
    OrderEventKind kind = OrderEventKind::compare;
    bool verdict = false;      ///< the question's answer, where the kind asks one
    Side side = Side::on;      ///< where the kind names one
    std::int8_t axis = -1;     ///< 0 x, 1 y, 2 z, where the kind names one
    std::int32_t polygon = -1; ///< index into the state's polygons
    std::int32_t other = -1;
    std::int32_t node = -1; ///< of a tree: index into the state's nodes or cells
    std::int32_t place = -1;
    double value = 0.0;
    double other_value = 0.0;
};

/// Takes a story; never steers. `State` is the algorithm's own (its polygons, lists, tree), as it
/// is after the event.
template <typename Sink, typename State>
concept OrderSink = requires(Sink sink, const OrderEvent& event, const State& state) {
    { sink.order_step(event, state) } -> std::same_as<void>;
};

/// Listens to nothing.
struct SilentOrder {
    template <typename State>
    void order_step(const OrderEvent&, const State&) {}
};

} // namespace hs::visibility
