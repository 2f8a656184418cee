#include "core/visibility/order_names.hpp"

namespace hs {

using namespace visibility; // NOLINT(google-build-using-namespace): tables of that room's
                            // enumerations

template <>
std::span<const Named<OrderEventKind>> names<OrderEventKind>() {
    static constexpr std::array<Named<OrderEventKind>, order_event_kind_count> table{{
        {OrderEventKind::compare, "comparison", "the keys of two polygons are compared"},
        {OrderEventKind::move, "move", "a polygon goes to another place of the list"},
        {OrderEventKind::emit, "emit", "a polygon is next in the order of drawing"},
        {OrderEventKind::overlap, "overlap", "two projections are held against each other"},
        {OrderEventKind::nearer, "depth", "two depths are compared where projections overlap"},
        {OrderEventKind::list_in_front, "front list", "a polygon enters the front list of another"},
        {OrderEventKind::iteration, "iteration", "a pass over the list begins"},
        {OrderEventKind::count_down, "count down", "a polygon has one undrawn one less behind it"},
        {OrderEventKind::stuck, "stuck", "a polygon can never be drawn: none has a counter of 0"},
        {OrderEventKind::take_farthest, "farthest", "the farthest polygon left becomes P"},
        {OrderEventKind::test,
         "test",
         "one of the five tests asks whether P may be drawn before Q"},
        {OrderEventKind::exchanged_test,
         "exchange",
         "test 3 or 4 asks whether Q may be drawn before P"},
        {OrderEventKind::draw_anyway,
         "draw anyway",
         "a cycle that no plane can cut is broken by drawing one polygon of it"},
        {OrderEventKind::split, "split", "a plane cuts a polygon in two"},
        {OrderEventKind::candidate, "candidate", "the splits a splitter would cost are counted"},
        {OrderEventKind::make_node, "node", "a polygon becomes the splitter of a node"},
        {OrderEventKind::classify, "classify", "a polygon is held against a node's plane"},
        {OrderEventKind::enter_node, "visit", "the walk comes to a node and asks for the eye"},
        {OrderEventKind::visit_side, "side", "the walk goes on on one side of a node"},
        {OrderEventKind::make_cell, "cell", "a cell of the octree is made"},
        {OrderEventKind::enter_cell, "cell visit", "the walk comes to a cell"},
        {OrderEventKind::in_front, "in front", "two polygons of one leaf are held against planes"},
        {OrderEventKind::undecided, "undecided", "a leaf's polygons have no order of their own"},
    }};
    return table;
}

template <>
std::span<const Named<NewellTest>> names<NewellTest>() {
    static constexpr std::array<Named<NewellTest>, 6> table{{
        {NewellTest::depth_extents, "depth extents", "no point of Q is farther than a point of P"},
        {NewellTest::x_extents, "x extents", "the extents in x do not overlap"},
        {NewellTest::y_extents, "y extents", "the extents in y do not overlap"},
        {NewellTest::behind_plane, "P behind Q", "P is wholly behind the plane of Q"},
        {NewellTest::in_front_of_plane,
         "Q before P",
         "Q is wholly on the eye's side of the plane of P"},
        {NewellTest::projections, "projections", "the projections do not overlap"},
    }};
    return table;
}

template <>
std::span<const Named<Side>> names<Side>() {
    static constexpr std::array<Named<Side>, 4> table{{
        {Side::on, "on", "every corner lies on the plane"},
        {Side::front, "front", "no corner lies behind the plane"},
        {Side::back, "back", "no corner lies in front of the plane"},
        {Side::spanning, "spanning", "some corners lie in front of the plane, some behind"},
    }};
    return table;
}

} // namespace hs
