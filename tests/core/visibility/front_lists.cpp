#include "core/visibility/front_lists.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/visible_surfaces.hpp"

#include <algorithm>

using namespace hs;
using visibility::FrontLists;
using visibility::OrderEvent;
using visibility::OrderEventKind;

namespace {

/// Numbers people count polygons with: from 1.
std::vector<std::int32_t> numbers(std::vector<std::int32_t> indices) {
    for (std::int32_t& index : indices) {
        ++index;
    }
    return indices;
}

/// The counters when the lists were complete, and what each iteration drew.
struct TableTrace {
    std::vector<std::int32_t> behind;
    std::vector<std::vector<std::int32_t>> iterations;
    std::vector<OrderEvent> events;
    void order_step(const OrderEvent& event, const FrontLists& lists) {
        events.push_back(event);
        if (event.kind == OrderEventKind::iteration) {
            behind = iterations.empty() ? lists.behind : behind;
            iterations.emplace_back();
        } else if (event.kind == OrderEventKind::emit) {
            iterations.back().push_back(event.polygon + 1);
        }
    }
};

using Numbers = std::vector<std::int32_t>;

} // namespace

TEST_CASE("the six polygons have the lecture's front lists and counters", "[visibility]") {
    TableTrace trace;
    const FrontLists lists = order_by_front_lists(tests::six_polygons(), trace);
    CHECK(numbers(lists.in_front[0]) == Numbers{5});
    CHECK(numbers(lists.in_front[1]) == Numbers{4, 3, 1});
    CHECK(numbers(lists.in_front[2]) == Numbers{1, 5});
    CHECK(numbers(lists.in_front[3]) == Numbers{3});
    CHECK(lists.in_front[4].empty());
    CHECK(lists.in_front[5].empty());
    CHECK(trace.behind == Numbers{2, 0, 2, 1, 2, 0});
}

TEST_CASE("the six polygons are drawn in the lecture's five iterations", "[visibility]") {
    TableTrace trace;
    const FrontLists lists = order_by_front_lists(tests::six_polygons(), trace);
    CHECK(trace.iterations == std::vector<Numbers>{{2, 6}, {4}, {3}, {1}, {5}});
    CHECK(lists.behind == Numbers{-1, -1, -1, -1, -1, -1});
    CHECK(lists.stuck.empty());
}

TEST_CASE("every pair is asked once", "[visibility]") {
    TableTrace trace;
    static_cast<void>(order_by_front_lists(tests::six_polygons(), trace));
    const auto asked = std::ranges::count(trace.events, OrderEventKind::overlap, &OrderEvent::kind);
    CHECK(asked == 15);
    CHECK(visibility::estimate_front_lists(6) == 15.0);
}

TEST_CASE(
    "a cycle and what is in front of it are stuck, what is behind it is drawn", "[visibility]"
) {
    auto polygons = tests::ring_of_bars(3);
    polygons.push_back(tests::window_rectangle(10, {0, 0}, {100, 100}, 0.9)); // a wall behind
    polygons.push_back(tests::window_rectangle(11, {0, 0}, {100, 100}, 0.1)); // a pane in front
    TableTrace trace;
    const FrontLists lists = order_by_front_lists(polygons, trace);
    CHECK(lists.order == Numbers{3});
    CHECK(lists.stuck == Numbers{0, 1, 2, 4});
    for (const OrderEvent& event : trace.events) {
        if (event.kind == OrderEventKind::stuck) {
            CHECK(event.verdict == (event.polygon < 3)); // the pane is not part of the cycle
        }
    }
}

TEST_CASE("overlapping polygons of one plane do not wait for each other", "[visibility]") {
    visibility::SilentOrder silent;
    for (const double rounding : {0.0, 0x1p-25, -0x1p-25}) {
        const FrontLists lists = order_by_front_lists(
            {tests::window_rectangle(0, {0, 0}, {9, 9}, 0.5),
             tests::window_rectangle(1, {3, 3}, {12, 12}, 0.5 + rounding)},
            silent
        );
        CHECK(lists.iterations == 1);
        CHECK(lists.order == Numbers{0, 1});
    }
}

TEST_CASE("no polygon, one polygon and one without area are drawn at once", "[visibility]") {
    visibility::SilentOrder silent;
    CHECK(order_by_front_lists({}, silent).order.empty());
    const auto line = tests::window_triangle(0, {1, 1, 0.2}, {5, 5, 0.5}, {9, 9, 0.8});
    CHECK(order_by_front_lists({line}, silent).order == Numbers{0});
    CHECK(order_by_front_lists({line, line, line}, silent).iterations == 1);
}
