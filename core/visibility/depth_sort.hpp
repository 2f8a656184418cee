// Depth sort: painter's algorithm that makes sure. The farthest polygon P is drawn only when five
// tests show that it hides no part of any Q; else Q goes first; and when they go in circles, one is
// cut.
//
// Newell, Newell and Sancha, A Solution to the Hidden Surface Problem, 1972. Differs: a polygon
// that was moved already is cut by P's plane or, where that misses it, P by its plane, or else some
// pair of those moved between them is cut; after a cut all go back to their places in the list.
//
// It ends. Each move marks an unmarked polygon, so there are at most as many moves as polygons
// between two cuts or drawings. Parts keep the plane of their polygon and lie on one side of every
// plane that cut them, so each of the n planes given cuts the ancestry of a part at most once: the
// number of cuts is finite. Where no plane cuts any pair of a cycle, P is drawn anyway. Exact
// arithmetic excludes that: all others would lie wholly on one side or the other of P's plane, the
// one that must precede P behind it, the one that P must precede in front; somewhere on the way
// around the cycle one in front would have to precede one behind.
#pragma once

#include "core/visibility/newell_tests.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

namespace hs::visibility {

/// The list, drawn polygons taken off its head, and what the tests have cost.
struct DepthSort {
    PolygonSet<WindowSpace> set; ///< planes have the eye in front
    std::vector<SortedPolygon> sorted;
    std::deque<std::int32_t> list;   ///< undrawn; from `chain` on by falling farthest depth
    std::size_t chain = 0;           ///< moved to the head since the last of them was drawn
    std::vector<std::int32_t> order; ///< drawn so far
    std::int32_t splits = 0;
};

/// Pairs that overlap in depth: at least that many are tested. Costs a sort.
[[nodiscard]] double estimate_depth_sort(std::span<const WindowPolygon> polygons);

/// The list by falling farthest depth; equal ones in the order of the file.
[[nodiscard]] DepthSort begin_depth_sort(std::vector<WindowPolygon> polygons);

/// Moves `list[place]` to the head and marks it.
void move_to_head(DepthSort& sort, std::size_t place);

/// Cuts polygon `i` by the plane of `by`, which it spans, and sorts the list again, with no polygon
/// marked: without the one that was cut, what was moved no longer has to precede what follows it.
/// Returns the new part.
std::int32_t cut(DepthSort& sort, std::int32_t i, std::int32_t by);

/// Which polygon to cut by whose plane.
struct Cut {
    std::int32_t polygon = -1; ///< −1: no plane cuts anything
    std::int32_t by = -1;
};

/// For a P that Q = `list[place]` should precede but may not: Q by P's plane if that cuts it, else
/// P by Q's, else the first pair of the chain and P where one cuts the other.
[[nodiscard]] Cut choose_cut(const DepthSort& sort, std::size_t place);

namespace depth_sort_steps {

using Kind = OrderEventKind;

/// Tests one after the other until one passes; `kind` says in which roles.
template <OrderSink<DepthSort> Sink>
[[nodiscard]] bool may_precede(
    const DepthSort& sort,
    Kind kind,
    std::span<const NewellTest> tests,
    std::pair<std::int32_t, std::int32_t> p_and_q,
    Sink& sink
) {
    for (const NewellTest test : tests) {
        const auto [p, q] = p_and_q;
        const NewellAnswer answer = ask(test, sort.set, sort.sorted, p, q);
        sink.order_step(
            {.kind = kind,
             .verdict = answer.passed,
             .side = answer.side,
             .polygon = p,
             .other = q,
             .place = static_cast<std::int32_t>(test),
             .value = answer.value,
             .other_value = answer.other_value},
            sort
        );
        if (answer.passed) {
            return true;
        }
    }
    return false;
}

inline constexpr std::array all_tests{
    NewellTest::depth_extents,
    NewellTest::x_extents,
    NewellTest::y_extents,
    NewellTest::behind_plane,
    NewellTest::in_front_of_plane,
    NewellTest::projections};
inline constexpr std::array plane_tests{NewellTest::behind_plane, NewellTest::in_front_of_plane};

/// The place in the list of the first polygon that P, its head, may hide; the list's length if
/// there is none.
template <OrderSink<DepthSort> Sink>
[[nodiscard]] std::size_t find_hidden(const DepthSort& sort, Sink& sink) {
    const std::int32_t p = sort.list.front();
    const double nearest = sort.sorted[static_cast<std::size_t>(p)].extents.low.z;
    for (std::size_t place = 1; place < sort.list.size(); ++place) {
        const std::int32_t q = sort.list[place];
        if (!may_precede(sort, Kind::test, all_tests, {p, q}, sink)) {
            return place;
        }
        // All after it are nearer still
        const double farthest = sort.sorted[static_cast<std::size_t>(q)].extents.high.z;
        if (place >= sort.chain && farthest <= nearest) {
            break;
        }
    }
    return sort.list.size();
}

template <OrderSink<DepthSort> Sink>
void draw_head(DepthSort& sort, Sink& sink) {
    const std::int32_t p = sort.list.front();
    sort.list.pop_front();
    sort.chain -= sort.chain > 0 ? 1U : 0U;
    sort.order.push_back(p);
    sink.order_step(
        {.kind = Kind::emit,
         .polygon = p,
         .place = static_cast<std::int32_t>(sort.order.size()) - 1},
        sort
    );
}

/// P may hide Q = `list[place]`: Q goes first, or something is cut.
template <OrderSink<DepthSort> Sink>
void resolve(DepthSort& sort, std::size_t place, Sink& sink) {
    const std::int32_t p = sort.list.front();
    const std::int32_t q = sort.list[place];

    // Exchange the roles: may Q be drawn before P?
    const bool may_move = may_precede(sort, Kind::exchanged_test, plane_tests, {q, p}, sink);
    if (may_move && !sort.sorted[static_cast<std::size_t>(q)].marked) {
        move_to_head(sort, place);
        sink.order_step({.kind = Kind::move, .polygon = q, .other = p, .place = 0}, sort);
        return;
    }

    // They penetrate each other, or Q has been moved before and this is a cycle
    const Cut choice = choose_cut(sort, place);
    if (choice.polygon < 0) {
        sink.order_step({.kind = Kind::draw_anyway, .polygon = p, .other = q}, sort);
        draw_head(sort, sink);
        return;
    }
    const std::int32_t part = cut(sort, choice.polygon, choice.by);
    sink.order_step(
        {.kind = Kind::split,
         .polygon = choice.polygon,
         .other = choice.by,
         .place = part,
         .value = area(sort.set.polygon(choice.polygon)),
         .other_value = area(sort.set.polygon(part))},
        sort
    );
}

} // namespace depth_sort_steps

/// `order` of the result holds every polygon and part once, back to front.
template <OrderSink<DepthSort> Sink>
[[nodiscard]] DepthSort sort_by_depth(std::vector<WindowPolygon> polygons, Sink& sink) {
    namespace steps = depth_sort_steps;
    DepthSort sort = begin_depth_sort(std::move(polygons));
    while (!sort.list.empty()) {
        // Take the farthest
        const std::int32_t p = sort.list.front();
        sink.order_step(
            {.kind = OrderEventKind::take_farthest,
             .polygon = p,
             .place = static_cast<std::int32_t>(sort.order.size()),
             .value = sort.sorted[static_cast<std::size_t>(p)].extents.high.z},
            sort
        );

        // Ask every Q that overlaps it in depth
        const std::size_t place = steps::find_hidden(sort, sink);
        if (place == sort.list.size()) {
            steps::draw_head(sort, sink);
        } else {
            steps::resolve(sort, place, sink);
        }
    }
    return sort;
}

} // namespace hs::visibility
