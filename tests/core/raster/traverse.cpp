#include "core/raster/traverse.hpp"

#include "core/geometry/facing.hpp"
#include "tests/support/catch.hpp"

#include <array>

using namespace hs;

namespace {

struct Cost : raster::SilentTraversal {
    int units = 0;
    int visited = 0;
    int covered = 0;

    void unit(int) { ++units; }
    void edge_test(PixelPos, const raster::EdgeValues&, bool inside) {
        ++visited;
        covered += inside ? 1 : 0;
    }
};

Cost cost_of(scene::TraversalKind kind, raster::UnitRange units = {}) {
    const std::array<FixedPosition, 3> v{{{256, 512}, {256, 1792}, {1536, 512}}}; // 6 × 6 centers
    const PixelRect image{0, 0, 10, 9};
    const auto setup = raster::set_up(v, geometry::doubled_area(v[0], v[1], v[2]), image);
    Cost cost;
    int emitted = 0;
    raster::traverse({kind}, setup, image, units, cost, [&](PixelPos, const raster::EdgeValues&) {
        ++emitted;
    });
    CHECK(emitted == cost.covered);
    return cost;
}

} // namespace

TEST_CASE("brute force asks every pixel of the image", "[raster]") {
    const Cost cost = cost_of(scene::TraversalKind::brute_force);
    CHECK(cost.visited == 90);
    CHECK(cost.units == 9);
    CHECK(cost.covered == 15);
}

TEST_CASE("the bounding box saves the pixels beside it", "[raster]") {
    const Cost cost = cost_of(scene::TraversalKind::bounding_box);
    CHECK(cost.visited == 36);
    CHECK(cost.units == 6);
    CHECK(cost.covered == 15);
}

TEST_CASE("a range of units asks only their rows", "[raster]") {
    CHECK(cost_of(scene::TraversalKind::bounding_box, {1, 3}).visited == 12);
    CHECK(cost_of(scene::TraversalKind::bounding_box, {1, 3}).covered == 4 + 3);
    CHECK(cost_of(scene::TraversalKind::bounding_box, {6, 9}).visited == 0);
}
