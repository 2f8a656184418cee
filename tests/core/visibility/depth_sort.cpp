#include "core/visibility/depth_sort.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/visible_surfaces.hpp"

#include <algorithm>
#include <set>

using namespace hs;
using tests::window_triangle;
using visibility::DepthSort;
using visibility::NewellTest;
using visibility::OrderEvent;
using visibility::OrderEventKind;
using visibility::WindowPolygon;

namespace {

using Numbers = std::vector<std::int32_t>;

struct EventTrace {
    std::vector<OrderEvent> events;
    void order_step(const OrderEvent& event, const DepthSort&) { events.push_back(event); }

    [[nodiscard]] std::ptrdiff_t count(OrderEventKind kind) const {
        return std::ranges::count(events, kind, &OrderEvent::kind);
    }
};

/// A triangle of the plane depth = z + x/100 · slope over a square's lower left half.
WindowPolygon
leaning(std::uint32_t number, double x, double y, double size, double z, double slope) {
    const auto at = [&](double dx, double dy) {
        return glm::dvec3{x + dx, y + dy, z + dx / 100.0 * slope};
    };
    return window_triangle(number, at(0, 0), at(size, 0), at(0, size));
}

/// The test that settles the first pair.
NewellTest deciding(const std::vector<WindowPolygon>& polygons) {
    EventTrace trace;
    static_cast<void>(visibility::sort_by_depth(polygons, trace));
    for (const OrderEvent& event : trace.events) {
        if (event.kind == OrderEventKind::test && event.verdict) {
            return static_cast<NewellTest>(event.place);
        }
    }
    FAIL("no test passed");
    return {};
}

bool every_part_is_drawn_once(const DepthSort& sort) {
    const std::set<std::int32_t> drawn(sort.order.begin(), sort.order.end());
    return drawn.size() == sort.order.size() &&
           static_cast<std::int32_t>(drawn.size()) == sort.set.size();
}

} // namespace

TEST_CASE("each of Newell's tests settles a pair that no cheaper one settles", "[visibility]") {
    const auto far = leaning(0, 20, 20, 20, 0.5, 0.5); // depths 0.5 to 0.6
    CHECK(deciding({far, leaning(1, 20, 20, 20, 0.2, 0)}) == NewellTest::depth_extents);
    CHECK(deciding({far, leaning(1, 50, 20, 20, 0.55, 0)}) == NewellTest::x_extents);
    CHECK(deciding({far, leaning(1, 20, 50, 20, 0.55, 0)}) == NewellTest::y_extents);
    CHECK(deciding({far, leaning(1, 20, 20, 10, 0.45, 0.6)}) == NewellTest::behind_plane);
    const auto behind_slope = window_triangle(0, {20, 20, 0.5}, {60, 20, 0.9}, {20, 60, 0.5});
    const auto before_slope = window_triangle(1, {30, 21, 0.4}, {31, 21, 0.58}, {30, 22, 0.2});
    CHECK(deciding({behind_slope, before_slope}) == NewellTest::in_front_of_plane);
    const auto corner = window_triangle(1, {60, 60, 0.0}, {60, 25, 0.99}, {25, 60, 0.2});
    CHECK(deciding({behind_slope, corner}) == NewellTest::projections);
}

TEST_CASE("a long triangle that reaches farthest is drawn after a short one", "[visibility]") {
    // The farthest point of the ramp is farther than the plate, but where they overlap it is nearer
    const auto ramp = window_triangle(0, {10, 10, 0.1}, {90, 10, 0.9}, {10, 30, 0.1});
    const auto plate = window_triangle(1, {10, 10, 0.5}, {20, 10, 0.5}, {10, 20, 0.5});
    EventTrace trace;
    const DepthSort sort = visibility::sort_by_depth({ramp, plate}, trace);
    CHECK(sort.order == Numbers{1, 0});
    CHECK(trace.count(OrderEventKind::move) == 1);
    CHECK(trace.count(OrderEventKind::exchanged_test) > 0);
    CHECK(sort.splits == 0);
}

TEST_CASE("triangles that penetrate each other are cut before anything moves", "[visibility]") {
    const auto red = window_triangle(0, {10, 10, 0.2}, {90, 10, 0.8}, {50, 90, 0.5});
    const auto blue = window_triangle(1, {10, 90, 0.8}, {50, 10, 0.5}, {90, 90, 0.2});
    EventTrace trace;
    const DepthSort sort = visibility::sort_by_depth({red, blue}, trace);
    CHECK(sort.splits == 1);
    CHECK(sort.order.size() == 3);
    const auto first_of = [&](OrderEventKind kind) {
        return std::ranges::find(trace.events, kind, &OrderEvent::kind);
    };
    CHECK(first_of(OrderEventKind::split) < first_of(OrderEventKind::move));
}

TEST_CASE("a cycle of three is cut", "[visibility]") {
    EventTrace trace;
    const DepthSort sort = visibility::sort_by_depth(tests::ring_of_bars(3), trace);
    CHECK(sort.splits >= 1);
    CHECK(every_part_is_drawn_once(sort));
    CHECK(trace.count(OrderEventKind::draw_anyway) == 0);
}

TEST_CASE("a cycle of a thousand ends", "[visibility]") {
    visibility::SilentOrder silent;
    const DepthSort sort = visibility::sort_by_depth(tests::ring_of_bars(1000), silent);
    CHECK(sort.splits >= 1);
    CHECK(every_part_is_drawn_once(sort));
}

TEST_CASE("one plane, duplicates and no area need no cut", "[visibility]") {
    std::vector<WindowPolygon> polygons;
    for (std::uint32_t i = 0; i < 50; ++i) {
        polygons.push_back(leaning(i, 20 + i % 5, 20 + i % 7, 30, 0.5 + i % 5 / 100.0, 1.0));
        polygons.push_back(polygons.front()); // again and again
        polygons.push_back(window_triangle(i, {10, 10, 0.1}, {50, 50, 0.5}, {90, 90, 0.9}));
        polygons.push_back(window_triangle(i, {30, 30, 0.4}, {30, 30, 0.4}, {30, 30, 0.4}));
    }
    EventTrace trace;
    const DepthSort sort = visibility::sort_by_depth(polygons, trace);
    CHECK(sort.splits == 0);
    CHECK(trace.count(OrderEventKind::draw_anyway) == 0);
    CHECK(every_part_is_drawn_once(sort));
    CHECK(visibility::sort_by_depth({}, trace).order.empty());
}

TEST_CASE("the estimate counts the pairs that overlap in depth", "[visibility]") {
    const std::vector<WindowPolygon> apart{
        leaning(0, 0, 0, 10, 0.1, 0.1), leaning(1, 0, 0, 10, 0.3, 0.1)};
    CHECK(visibility::estimate_depth_sort(apart) == 0.0);
    const std::vector<WindowPolygon> chain{
        leaning(0, 0, 0, 10, 0.1, 1.0),
        leaning(1, 0, 0, 10, 0.15, 1.0),
        leaning(2, 0, 0, 10, 0.22, 1.0)};
    CHECK(visibility::estimate_depth_sort(chain) == 2.0);
}
