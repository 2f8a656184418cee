#include "core/visibility/bsp.hpp"

#include "core/visibility/bsp_walk.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/visible_surfaces.hpp"

#include <algorithm>

using namespace hs;
using tests::world_triangle;
using visibility::BspTree;
using visibility::OrderEvent;
using visibility::OrderEventKind;
using visibility::Side;
using visibility::Splitter;
using visibility::WalkOrder;
using visibility::WorldPolygon;

namespace {

using Numbers = std::vector<std::int32_t>;

constexpr glm::dvec4 eye_above{0, 0, 100, 1};
constexpr glm::dvec4 eye_below{0, 0, -100, 1};

struct EventTrace {
    std::vector<OrderEvent> events;
    template <typename State>
    void order_step(const OrderEvent& event, const State&) {
        events.push_back(event);
    }
    [[nodiscard]] std::vector<OrderEvent> of(OrderEventKind kind) const {
        std::vector<OrderEvent> result;
        std::ranges::copy_if(events, std::back_inserter(result), [&](const OrderEvent& event) {
            return event.kind == kind;
        });
        return result;
    }
};

/// A triangle in the plane z, seen counter-clockwise from above.
WorldPolygon floor_at(std::uint32_t number, double z) {
    return world_triangle(number, {0, 0, z}, {1, 0, z}, {0, 1, z});
}

std::vector<WorldPolygon> floors(std::uint32_t count) {
    std::vector<WorldPolygon> polygons;
    for (std::uint32_t i = 0; i < count; ++i) {
        polygons.push_back(floor_at(i, i));
    }
    return polygons;
}

Numbers back_to_front(const BspTree& tree, const glm::dvec4& eye) {
    visibility::SilentOrder silent;
    return visibility::walk_bsp(tree, eye, WalkOrder::back_to_front, silent).order;
}

BspTree tree_of(std::vector<WorldPolygon> polygons, visibility::BspOptions options = {}) {
    visibility::SilentOrder silent;
    return visibility::build_bsp(std::move(polygons), options, silent);
}

} // namespace

TEST_CASE("one tree orders floors for an eye above and an eye below", "[visibility]") {
    const BspTree tree = tree_of({floor_at(0, 1), floor_at(1, 2), floor_at(2, 0)});
    CHECK(back_to_front(tree, eye_above) == Numbers{2, 0, 1});
    CHECK(back_to_front(tree, eye_below) == Numbers{1, 0, 2});
    CHECK(back_to_front(tree, {0, 0, 0.5, 1}) == Numbers{1, 0, 2}); // between the floors
    CHECK(back_to_front(tree, {0, 0, 1, 0}) == Numbers{2, 0, 1});   // infinitely far above
}

TEST_CASE("the first polygon of a list splits what spans its plane", "[visibility]") {
    EventTrace trace;
    const auto wall = world_triangle(1, {0.2, 0.2, -1}, {0.4, 0.2, 2}, {0.2, 0.4, 2});
    const BspTree tree = visibility::build_bsp({floor_at(0, 0), wall}, {}, trace);
    REQUIRE(tree.nodes.size() == 3);
    CHECK(tree.splits == 1);
    CHECK(tree.nodes[0].polygons == Numbers{0});
    CHECK(tree.nodes[1].polygons == Numbers{1}); // the part in front keeps its index
    CHECK(tree.nodes[2].polygons == Numbers{2});
    CHECK(tree.set.polygon(2).part == 1);
    CHECK(tree.set.polygon(2).triangle == 1);
    CHECK(trace.of(OrderEventKind::split).size() == 1);
    CHECK(back_to_front(tree, eye_above) == Numbers{2, 0, 1});
}

TEST_CASE(
    "polygons of one plane stay at their node, the first of the file on top", "[visibility]"
) {
    const BspTree tree = tree_of({floor_at(0, 0), floor_at(1, 0), floor_at(2, 0)});
    CHECK(tree.nodes.size() == 1);
    CHECK(back_to_front(tree, eye_above) == Numbers{2, 1, 0});
    visibility::SilentOrder silent;
    const auto near = visibility::walk_bsp(tree, eye_above, WalkOrder::front_to_back, silent);
    CHECK(near.order == Numbers{0, 1, 2});
}

TEST_CASE("fewest splits asks candidates and takes the first of the best", "[visibility]") {
    EventTrace trace;
    // The floor would split both walls, either wall only the floor, the lid nothing
    const auto wall = [](std::uint32_t number, double x) {
        return world_triangle(number, {x, 0.1, -1}, {x, 0.3, 1}, {x, 0.1, 1});
    };
    const BspTree tree = visibility::build_bsp(
        {floor_at(0, 0), wall(1, 0.2), wall(2, 0.4), floor_at(3, 5)},
        {.splitter = Splitter::fewest_splits},
        trace
    );
    const auto candidates = trace.of(OrderEventKind::candidate);
    REQUIRE(candidates.size() >= 4);
    CHECK(candidates[0].value == 2.0);
    CHECK(candidates[1].value == 2.0); // the floor, and the lid reaches across, too
    CHECK(candidates[3].value == 0.0);
    CHECK(candidates[3].verdict);
    CHECK(tree.nodes[0].polygons == Numbers{3});
}

TEST_CASE("long lists are asked by a few candidates", "[visibility]") {
    CHECK(visibility::candidate_places(3) == Numbers{0, 1, 2});
    const Numbers places = visibility::candidate_places(100'000);
    CHECK(static_cast<std::int32_t>(places.size()) == visibility::max_candidates);
    CHECK(std::ranges::adjacent_find(places) == places.end());
    CHECK(places.back() < 100'000);
}

TEST_CASE("a random tree depends on nothing but its seed", "[visibility]") {
    const auto root = [](std::uint64_t seed) {
        return tree_of(floors(100), {Splitter::random, seed}).nodes[0].polygons[0];
    };
    CHECK(root(1) == root(1));
    CHECK((root(1) != root(2) || root(2) != root(3)));
}

TEST_CASE("a tree as deep as a list is long is built and walked", "[visibility]") {
    // Every floor has all that follow it in front
    const BspTree tree = tree_of(floors(5000));
    CHECK(tree.nodes.size() == 5000);
    CHECK(tree.nodes.back().parent == 4998);
    CHECK(back_to_front(tree, {0, 0, 1e6, 1}).back() == 4999);
    CHECK(back_to_front(tree, eye_below).back() == 0);
}

TEST_CASE("a chain of a hundred thousand nodes is walked without recursion", "[visibility]") {
    BspTree tree;
    tree.set = visibility::polygon_set(floors(100'000));
    for (std::int32_t i = 0; i < 100'000; ++i) {
        visibility::BspNode node{.plane = tree.set.plane(i), .polygons = {i}, .parent = i - 1};
        node.front = i + 1 < 100'000 ? i + 1 : -1;
        tree.nodes.push_back(node);
    }
    CHECK(back_to_front(tree, {0, 0, 1e6, 1}).back() == 99'999);
    CHECK(back_to_front(tree, eye_below).back() == 0);
}

TEST_CASE("polygons without area are ordered, but split nothing", "[visibility]") {
    const auto line = world_triangle(0, {0, 0, -1}, {0, 0, 0}, {0, 0, 1});
    const BspTree tree = tree_of({line, floor_at(1, 3), line});
    CHECK(tree.nodes[0].polygons == Numbers{1});
    CHECK(back_to_front(tree, eye_above).size() == 3);
    CHECK(tree_of({line, line}).nodes.size() == 1);
    CHECK(tree_of({}).nodes.empty());
    CHECK(back_to_front(tree_of({}), eye_above).empty());
}

TEST_CASE("the walk tells on which side of every node the eye is", "[visibility]") {
    const BspTree tree = tree_of({floor_at(0, 1), floor_at(1, 2), floor_at(2, 0)});
    EventTrace trace;
    static_cast<void>(visibility::walk_bsp(tree, eye_above, WalkOrder::back_to_front, trace));
    const auto entered = trace.of(OrderEventKind::enter_node);
    REQUIRE(entered.size() == 3);
    CHECK(entered[0].verdict);
    CHECK(entered[0].value == 99.0); // twice the floor's area times 99 above it
    const auto sides = trace.of(OrderEventKind::visit_side);
    REQUIRE(sides.size() == 2);
    CHECK(sides[0].side == Side::back);
    CHECK(sides[1].side == Side::front);
}

TEST_CASE("the estimate knows a convex surface from triangles in no order", "[visibility]") {
    std::vector<WorldPolygon> bowl; // each triangle touches a paraboloid
    for (std::uint32_t i = 0; i < 3600; ++i) {
        const double x = i % 60 / 30.0 - 1.0;
        const std::uint32_t row = i / 60;
        const double y = row / 30.0 - 1.0;
        const auto at = [&](double dx, double dy) {
            return glm::dvec3{x + dx, y + dy, x * x + y * y + 2 * x * dx + 2 * y * dy};
        };
        bowl.push_back(world_triangle(i, at(0, 0), at(0.001, 0), at(0, 0.001)));
    }
    tests::Random random(411);
    for (const auto& polygons : {bowl, tests::random_world_triangles(10'000, 0.01F, random)}) {
        struct Counter {
            double classified = 0.0;
            void order_step(const OrderEvent& event, const BspTree&) {
                classified += event.kind == OrderEventKind::classify ? 1.0 : 0.0;
            }
        } counter;
        static_cast<void>(visibility::build_bsp(polygons, {}, counter));
        const double estimate = visibility::estimate_bsp(polygons, {});
        CHECK(estimate > counter.classified / 3.0);
        CHECK(estimate < counter.classified * 3.0);
    }
}
