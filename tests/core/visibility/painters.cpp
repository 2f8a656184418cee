#include "core/visibility/painters.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace hs;
using visibility::OrderEvent;
using visibility::OrderEventKind;
using visibility::PaintersSort;
using visibility::WindowPolygon;

namespace {

WindowPolygon at_depths(std::initializer_list<double> depths) {
    WindowPolygon polygon;
    for (const double depth : depths) {
        polygon.corners.push_back({.position = {0.0, 0.0, depth}, .weights = {}});
    }
    return polygon;
}

/// Flat triangles at depths of which many are equal.
std::vector<WindowPolygon> random_polygons(std::uint64_t seed) {
    tests::Random random(seed);
    std::vector<WindowPolygon> polygons;
    const std::uint32_t count = random.below(40);
    for (std::uint32_t i = 0; i < count; ++i) {
        const double depth = static_cast<double>(random.below(12)) / 12.0;
        polygons.push_back(at_depths({depth, depth, depth}));
    }
    return polygons;
}

struct Events {
    std::vector<OrderEvent> list;
    void order_step(const OrderEvent& event, const PaintersSort&) { list.push_back(event); }

    [[nodiscard]] std::size_t count(OrderEventKind kind) const {
        return static_cast<std::size_t>(std::count_if(
            list.begin(), list.end(), [kind](const OrderEvent& event) { return event.kind == kind; }
        ));
    }
};

std::size_t ceil_log2(std::size_t n) {
    std::size_t log = 0;
    while ((std::size_t{1} << log) < n) {
        ++log;
    }
    return log;
}

} // namespace

TEST_CASE("a polygon stands at its farthest, its nearest or its average depth", "[visibility]") {
    const WindowPolygon polygon = at_depths({0.25, 0.75, 0.5});
    CHECK(visibility::painters_key(polygon, scene::PaintersKey::farthest) == 0.75);
    CHECK(visibility::painters_key(polygon, scene::PaintersKey::nearest) == 0.25);
    CHECK(visibility::painters_key(polygon, scene::PaintersKey::centroid) == 0.5);
}

TEST_CASE("painter's order is farthest first, ties in file order", "[visibility][property]") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const std::vector<WindowPolygon> polygons = random_polygons(seed);
        std::vector<std::int32_t> expected(polygons.size());
        std::iota(expected.begin(), expected.end(), 0);
        const auto depth = [&polygons](std::int32_t i) {
            return polygons[static_cast<std::size_t>(i)].corners.front().position.z;
        };
        std::stable_sort(
            expected.begin(),
            expected.end(),
            [&depth](std::int32_t a, std::int32_t b) { return depth(a) > depth(b); }
        );
        visibility::SilentOrder nothing;
        INFO("seed " << seed);
        CHECK(
            visibility::sort_painters(polygons, scene::PaintersKey::farthest, nothing).order ==
            expected
        );
    }
}

TEST_CASE("a merge sort costs at most n ⌈log₂ n⌉ comparisons", "[visibility][property]") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const std::vector<WindowPolygon> polygons = random_polygons(seed);
        const std::size_t n = polygons.size();
        Events events;
        static_cast<void>(visibility::sort_painters(polygons, scene::PaintersKey::farthest, events)
        );
        INFO("seed " << seed << ", " << n << " polygons");
        CHECK(events.count(OrderEventKind::compare) <= n * ceil_log2(n));
        CHECK(events.count(OrderEventKind::move) == n * ceil_log2(n));
        CHECK(events.count(OrderEventKind::iteration) == ceil_log2(n));
        CHECK(events.count(OrderEventKind::emit) == n);
    }
}

TEST_CASE("what a comparison says is what happens next", "[visibility][property]") {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        Events events;
        static_cast<void>(
            visibility::sort_painters(random_polygons(seed), scene::PaintersKey::farthest, events)
        );
        for (std::size_t i = 0; i + 1 < events.list.size(); ++i) {
            const OrderEvent& event = events.list[i];
            if (event.kind != OrderEventKind::compare) {
                continue;
            }
            const OrderEvent& next = events.list[i + 1];
            REQUIRE(event.verdict == (event.value > event.other_value));
            REQUIRE(next.kind == OrderEventKind::move);
            REQUIRE(next.polygon == (event.verdict ? event.polygon : event.other));
            REQUIRE(next.place == event.place);
        }
    }
}
