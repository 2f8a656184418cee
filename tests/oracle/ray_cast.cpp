// Rays one by one, against Embree. Rays that pass within 10⁻⁵ of an edge or meet two triangles as
// near to each other may differ.
#include "core/visibility/ray_cast.hpp"

#include "core/visibility/bsp_walk.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/ray_world.hpp"
#include "tests/support/visible_surfaces.hpp"

#include <glm/vec4.hpp>

#include <limits>

using namespace hs;

namespace {

constexpr double honest_margin = 1.0e-5; ///< of the cube's half side

/// The same triangles for every opponent.
struct World {
    std::vector<visibility::WorldPolygon> polygons;
    std::vector<visibility::RayTriangle> triangles;
    std::vector<glm::vec4> corners;
};

World random_world(std::uint32_t count, float size, tests::Random& random) {
    World world;
    world.polygons = tests::random_world_triangles(count, size, random);
    for (const visibility::WorldPolygon& polygon : world.polygons) {
        visibility::RayTriangle triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            triangle[k] = polygon.corners[k].position;
            world.corners.emplace_back(glm::vec3{triangle[k]}, 1.0F);
        }
        world.triangles.push_back(triangle);
    }
    return world;
}

/// With coordinates in float, as Embree takes them.
tests::Ray float_ray(const glm::dvec4& eye, tests::Random& random) {
    const tests::Ray ray = tests::random_ray(eye, random);
    return {glm::dvec3{glm::vec3{ray.origin}}, 20.0 * glm::dvec3{glm::vec3{ray.direction}}};
}

} // namespace

TEST_CASE("a cast ray keeps the triangle that Embree's ray hits first", "[oracle][visibility]") {
    tests::Random random(471);
    visibility::SilentSweep silent;
    int asked = 0;
    int hits = 0;
    int wrong = 0;
    for (int round = 0; round < 40; ++round) {
        const World world =
            random_world(1 + random.below(300), random.between(0.05F, 0.7F), random);
        const tests::RayWorld embree(world.corners);
        for (int i = 0; i < 500; ++i) {
            const glm::dvec4 eye{
                random.between(-2, 2), random.between(-2, 2), random.between(-2, 2), 1.0};
            const tests::Ray ray = float_ray(eye, random);
            if (!tests::nearest_met(world.polygons, ray, honest_margin)) {
                continue;
            }
            const int hit =
                embree.first_hit(glm::vec3{ray.origin}, glm::vec3{ray.direction}, 0.0F, 1.0F);
            const visibility::RayCast cast =
                visibility::cast_ray({ray.origin, ray.direction}, world.triangles, silent);
            ++asked;
            hits += hit >= 0 ? 1 : 0;
            wrong += hit == cast.nearest ? 0 : 1;
        }
    }
    INFO(asked << " rays, " << hits << " hit");
    CHECK(wrong == 0);
    CHECK(asked > 15'000);
    CHECK(hits > asked / 3);
}

TEST_CASE("the first polygon a BSP walk meets is what Embree's ray hits", "[oracle][visibility]") {
    tests::Random random(472);
    visibility::SilentOrder silent;
    int asked = 0;
    int wrong = 0;
    for (int round = 0; round < 30; ++round) {
        const World world = random_world(100, 0.6F, random);
        const tests::RayWorld embree(world.corners);
        const auto tree = visibility::build_bsp(
            world.polygons, {.splitter = visibility::Splitter::fewest_splits}, silent
        );
        for (int k = 0; k < 5; ++k) {
            const glm::dvec4 eye{
                random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), 1.0};
            const auto walk =
                visibility::walk_bsp(tree, eye, visibility::WalkOrder::front_to_back, silent);
            for (int i = 0; i < 50; ++i) {
                const tests::Ray ray = float_ray(eye, random);
                const auto first =
                    tests::first_met(tree.set.polygons, walk.order, ray, honest_margin);
                if (!first || !tests::nearest_met(world.polygons, ray, honest_margin)) {
                    continue;
                }
                const int hit = embree.first_hit(
                    glm::vec3{ray.origin},
                    glm::vec3{ray.direction},
                    0.0F,
                    std::numeric_limits<float>::infinity()
                );
                ++asked;
                wrong += hit == *first ? 0 : 1;
            }
        }
    }
    CHECK(wrong == 0);
    CHECK(asked > 5'000);
}
