#include "core/visibility/octree.hpp"

#include "core/visibility/octree_walk.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/visible_surfaces.hpp"

#include <algorithm>
#include <set>

using namespace hs;
using tests::world_triangle;
using visibility::Octree;
using visibility::OctreeOptions;
using visibility::OrderEvent;
using visibility::OrderEventKind;
using visibility::WorldPolygon;

namespace {

using Numbers = std::vector<std::int32_t>;

Octree tree_of(std::vector<WorldPolygon> polygons, const OctreeOptions& options = {}) {
    visibility::SilentOrder silent;
    return visibility::build_octree(std::move(polygons), options, silent);
}

/// A small triangle near a corner of the cube from −1 to 1.
WorldPolygon speck(std::uint32_t number, double x, double y, double z) {
    return world_triangle(number, {x, y, z}, {0.9 * x, y, z}, {x, 0.9 * y, z});
}

/// One in every octant, numbered like them.
std::vector<WorldPolygon> eight_specks() {
    std::vector<WorldPolygon> polygons;
    for (std::uint32_t k = 0; k < 8; ++k) {
        const auto side = [&](unsigned axis) { return (k >> axis & 1U) != 0 ? 1.0 : -1.0; };
        polygons.push_back(speck(k, side(0), side(1), side(2)));
    }
    return polygons;
}

} // namespace

TEST_CASE("a cell with more polygons than allowed is divided once they part", "[visibility]") {
    const Octree tree = tree_of(eight_specks(), {.occupancy = 1});
    REQUIRE(tree.cells.size() == 9);
    CHECK_FALSE(tree.cells[0].leaf);
    CHECK(tree.splits == 0);
    for (std::size_t k = 0; k < 8; ++k) {
        const auto child = tree.cells[0].children[k];
        CHECK(
            tree.cells[static_cast<std::size_t>(child)].polygons ==
            Numbers{static_cast<std::int32_t>(k)}
        );
    }
    CHECK(tree_of(eight_specks(), {.occupancy = 8}).cells.size() == 1);
}

TEST_CASE("cells are visited from the eye's eighth to the opposite one", "[visibility]") {
    const Octree tree = tree_of(eight_specks(), {.occupancy = 1});
    visibility::SilentOrder silent;
    CHECK(
        visibility::walk_octree(tree, {-5, -5, -5, 1}, silent).order ==
        Numbers{0, 1, 2, 4, 3, 5, 6, 7}
    );
    CHECK(
        visibility::walk_octree(tree, {1, 1, 1, 0}, silent).order == Numbers{7, 6, 5, 3, 4, 2, 1, 0}
    );
    CHECK(visibility::walk_octree(tree, {0.5, 0.5, -0.5, 1}, silent).order.front() == 3);
}

TEST_CASE("polygons are cut at the walls of the cells they cross", "[visibility]") {
    auto polygons = eight_specks();
    polygons.push_back(world_triangle(8, {-0.5, 0.1, 0.2}, {0.5, 0.1, 0.2}, {0.5, 0.3, 0.2}));
    const Octree tree = tree_of(polygons, {.occupancy = 2});
    CHECK(tree.splits == 1); // across x = 0 only
    REQUIRE(tree.set.size() == 10);
    CHECK(tree.set.polygon(8).corners.size() + tree.set.polygon(9).corners.size() == 7);
    CHECK(
        visibility::area(tree.set.polygon(8)) + visibility::area(tree.set.polygon(9)) ==
        Approx(visibility::area(polygons[8])).epsilon(1e-15)
    );
}

TEST_CASE("duplicates stop at the depth limit, in the order of the file", "[visibility]") {
    const std::vector<WorldPolygon> same(10, speck(0, 1, 1, 1));
    const Octree tree = tree_of(same, {.occupancy = 1, .depth = 4});
    std::int32_t deepest = 0;
    for (const visibility::OctreeCell& cell : tree.cells) {
        deepest = std::max(deepest, cell.depth);
    }
    CHECK(deepest == 4);
    visibility::SilentOrder silent;
    const auto walk = visibility::walk_octree(tree, {5, 5, 5, 1}, silent);
    CHECK(walk.undecided == 0); // one plane: none hides another
    CHECK(static_cast<std::int32_t>(walk.order.size()) == tree.set.size());
}

TEST_CASE("the number of parts is limited", "[visibility]") {
    tests::Random random(421);
    const auto triangles = tests::random_world_triangles(50, 1.0F, random);
    const Octree tree = tree_of(triangles, {.occupancy = 1, .depth = 20, .max_parts = 500});
    CHECK(tree.set.size() >= 500);
    CHECK(tree.set.size() < 2000); // what the last divided cell added
}

TEST_CASE("a leaf whose triangles hide each other in a circle says so", "[visibility]") {
    std::vector<WorldPolygon> ring;
    for (const auto& bar : tests::ring_of_bars(3)) {
        const auto at = [&](std::size_t k) {
            return bar.corners[k].position / glm::dvec3{50, 50, 1};
        };
        ring.push_back(world_triangle(bar.triangle, at(0), at(1), at(2)));
    }
    const Octree tree = tree_of(ring);
    REQUIRE(tree.cells.size() == 1);
    struct Trace {
        int undecided = 0;
        void order_step(const OrderEvent& event, const visibility::OctreeWalk&) {
            undecided += event.kind == OrderEventKind::undecided ? 1 : 0;
        }
    } trace;
    const auto walk = visibility::walk_octree(tree, {0, 0, -1, 0}, trace);
    CHECK(walk.undecided >= 1);
    CHECK(trace.undecided == walk.undecided);
    CHECK(walk.order.size() == 3);
}

TEST_CASE("an empty octree and one of polygons without area have an order", "[visibility]") {
    visibility::SilentOrder silent;
    CHECK(visibility::walk_octree(tree_of({}), {0, 0, 0, 1}, silent).order.empty());
    const auto point = world_triangle(0, {1, 1, 1}, {1, 1, 1}, {1, 1, 1});
    const Octree tree = tree_of(std::vector<WorldPolygon>(20, point));
    CHECK(visibility::walk_octree(tree, {0, 0, 0, 1}, silent).order.size() == 20);
}
