// What each traversal spends on a right triangle whose legs are n pixels long, against a count by
// hand.
#include "core/raster/cost.hpp"

#include "core/geometry/facing.hpp"
#include "core/raster/traverse.hpp"
#include "core/trace/comparison.hpp"
#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

#include <array>

using namespace hs;
using raster::Cost;

namespace {

constexpr std::uint64_t n = 16;
constexpr std::uint64_t box = (n + 1) * (n + 1);   // centers on the vertices count
constexpr std::uint64_t covered = n * (n + 1) / 2; // the hypotenuse owns no ties
constexpr std::uint64_t image = std::uint64_t{20} * 30;

struct Sum : raster::SilentTraversal {
    Cost total;
    void cost(const Cost& cost) { total += cost; }
};

/// Vertices on the centers of pixels (0, 0), (n, 0) and (0, n).
Cost spent(scene::TraversalKind kind) {
    constexpr auto leg = static_cast<std::int32_t>(n) * subpixel_scale;
    const std::array<FixedPosition, 3> v{{{0, 0}, {0, leg}, {leg, 0}}};
    const auto setup = raster::set_up(v, geometry::doubled_area(v[0], v[1], v[2]), {0, 0, 20, 30});
    Sum sum;
    std::uint64_t emitted = 0;
    raster::traverse(
        {kind},
        setup,
        {0, 0, 20, 30},
        {},
        sum,
        [&](PixelPos, const raster::EdgeValues&) { ++emitted; }
    );
    CHECK(emitted == covered);
    return sum.total;
}

} // namespace

TEST_CASE("an evaluation is two multiplications and two additions", "[raster][cost]") {
    const Cost cost{.evaluations = 3, .products = 1, .sums = 5};
    CHECK(cost.multiplications() == 7);
    CHECK(cost.additions() == 11);
}

TEST_CASE("brute force evaluates three edges at every pixel of the image", "[raster][cost]") {
    const Cost cost = spent(scene::TraversalKind::brute_force);
    CHECK(cost == Cost{.pixels = image, .evaluations = 3 * image});
    CHECK(cost.multiplications() == 6 * image);
    CHECK(cost.additions() == 6 * image);
}

TEST_CASE("the bounding box evaluates three edges at every pixel of the box", "[raster][cost]") {
    CHECK(spent(scene::TraversalKind::bounding_box) == Cost{.pixels = box, .evaluations = 3 * box});
}

TEST_CASE("incremental adds thrice per pixel and thrice per row", "[raster][cost]") {
    CHECK(
        spent(scene::TraversalKind::incremental) ==
        Cost{.pixels = box, .evaluations = 3, .sums = 3 * box + 3 * (n + 1)}
    );
}

TEST_CASE("serpentine adds thrice per pixel", "[raster][cost]") {
    CHECK(
        spent(scene::TraversalKind::serpentine) ==
        Cost{.pixels = box, .evaluations = 3, .sums = 3 * box}
    );
}

TEST_CASE("tiles of 8 and 4 save what their corners decide", "[raster][cost]") {
    // Of 3 × 3 tiles of 8: (0, 0) is accepted; (1, 0) and (0, 1) are cut by the hypotenuse, and of
    // their quarters one is accepted, two are asked, one is rejected; the six others are rejected.
    constexpr std::uint64_t tiles = 9 + 2 * 4;
    constexpr std::uint64_t pixels = 64 + 2 * 3 * 16;
    constexpr std::uint64_t rows = 8 + 2 * 3 * 4;
    CHECK(
        spent(scene::TraversalKind::hierarchical) ==
        Cost{
            .pixels = pixels,
            .tiles = tiles,
            .evaluations = 12 * tiles,
            .sums = 3 * pixels + 3 * rows}
    );
}

TEST_CASE("walking edges visits what is covered and nothing else", "[raster][cost]") {
    // One edge on each side, set up once and moved n − 1 times; it always meets whole pixels
    constexpr std::uint64_t edges = 2;
    const Cost expected{
        .pixels = covered,
        .evaluations = 3 * n,
        .products = edges,
        .sums = edges + 2 * edges * (n - 1) + 3 * covered,
        .divisions = 2 * edges};
    CHECK(spent(scene::TraversalKind::edge_walk) == expected);
    CHECK(spent(scene::TraversalKind::edge_table) == expected);
}

TEST_CASE("homogeneous rasterization evaluates three planes and adds up 1/w", "[raster][cost]") {
    CHECK(
        spent(scene::TraversalKind::homogeneous) ==
        Cost{.pixels = box, .evaluations = 3 * box, .sums = 2 * box}
    );
}

TEST_CASE(
    "the comparison of all traversals is what recording each of them counts", "[raster][cost]"
) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        auto scene = std::make_shared<scene::Scene>(*tests::random_scene(seed));
        if (scene->settings.orders_triangles()) {
            scene->settings.visibility = scene::Visibility::painters; // leaves all of them whole
        } else if (scene->settings.sweeps()) {
            scene->settings.visibility = scene::Visibility::none; // which traverses them
        }
        const auto rows = trace::compare_traversals(scene);
        REQUIRE(rows.size() == names<scene::TraversalKind>().size());
        for (const trace::TraversalCost& row : rows) {
            auto variant = std::make_shared<scene::Scene>(*scene);
            variant->settings.traversal = row.traversal;
            const auto recording = trace::record(variant);
            REQUIRE(recording);
            INFO("seed " << seed << ", " << name_of(row.traversal));
            CHECK((*recording)->counters.traversal == row.cost);
            CHECK((*recording)->counters.fragments == row.fragments);
        }
    }
}

TEST_CASE("the costs of a frame are the sum of its triangles'", "[raster][cost]") {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const auto scene = tests::random_scene(seed);
        const auto whole = trace::compare_traversals(scene);
        const auto recording = trace::record(scene).value();
        for (std::size_t kind = 0; kind < whole.size(); ++kind) {
            Cost sum;
            for (std::uint32_t object = 0; object < scene->objects.size(); ++object) {
                const std::size_t triangles = scene->objects[object].mesh->triangles.size();
                for (std::uint32_t t = 0; t < triangles; ++t) {
                    const Cost one = trace::compare_traversals(scene, {{object, t}})[kind].cost;
                    CHECK(trace::compare_traversals(*recording, {object, t})[kind].cost == one);
                    sum += one;
                }
            }
            CHECK(sum == whole[kind].cost);
        }
    }
}
