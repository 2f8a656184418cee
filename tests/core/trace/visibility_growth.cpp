#include "core/trace/visibility_growth.hpp"

#include "core/scene/triangulate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

using namespace hs;
using scene::Visibility;

namespace {

/// Small triangles anywhere in the view volume.
scene::Scene many_triangles(std::uint32_t count) {
    tests::Random random(481);
    auto mesh = std::make_shared<scene::Mesh>();
    mesh->polygon_start.push_back(0);
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 center{
            random.between(-0.8F, 0.8F), random.between(-0.8F, 0.8F), random.between(-0.8F, 0.8F)};
        for (int corner = 0; corner < 3; ++corner) {
            const glm::vec3 offset{
                random.between(-0.2F, 0.2F),
                random.between(-0.2F, 0.2F),
                random.between(-0.2F, 0.2F)};
            mesh->polygon_vertices.push_back(3 * i + static_cast<std::uint32_t>(corner));
            mesh->positions.emplace_back(center + offset, 1.0F);
        }
        mesh->polygon_start.push_back(3 * (i + 1));
    }
    scene::finish_mesh(*mesh);
    scene::Scene scene;
    scene.settings.width = 16;
    scene.settings.height = 16;
    scene.camera.projection.kind = scene::ProjectionKind::identity;
    scene.objects.emplace_back();
    scene.objects.back().mesh = mesh;
    return scene;
}

std::uint64_t questions(const trace::GrowthPoint& point, Visibility visibility) {
    const auto& outcome = point.outcomes[static_cast<std::size_t>(visibility)];
    REQUIRE(outcome.refusal.empty());
    return outcome.questions;
}

} // namespace

TEST_CASE("questions grow with polygons as each algorithm must", "[trace][visibility]") {
    const auto points = trace::visibility_growth(many_triangles(64));
    REQUIRE(points.size() == 5);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t n = points[i].triangles;
        INFO(n << " triangles");
        CHECK(n == std::size_t{4} << i);
        CHECK(questions(points[i], Visibility::none) == 0);
        CHECK(questions(points[i], Visibility::front_lists) >= n * (n - 1) / 2);
        CHECK(questions(points[i], Visibility::painters) < n * 7); // n log n
        const std::uint64_t rays = questions(points[i], Visibility::ray_cast);
        CHECK(rays >= 256 * n);        // every pixel, every triangle
        CHECK(rays < 256 * n * 3 / 2); // and some hits
        // A z-buffer and a line of depths are asked the same
        CHECK(
            questions(points[i], Visibility::scanline_z) ==
            questions(points[i], Visibility::z_buffer)
        );
    }
}

TEST_CASE("a thinned scene keeps every other polygon of the file", "[trace]") {
    const scene::Scene scene = many_triangles(9);
    const scene::Scene half = trace::thinned(scene, 1, 2);
    const auto& kept = half.objects[0].mesh->triangles;
    const auto& all = scene.objects[0].mesh->triangles;
    REQUIRE(kept.size() == 4);
    for (std::size_t i = 0; i < kept.size(); ++i) {
        CHECK(kept[i] == all[2 * i + 1]);
    }
    CHECK(trace::thinned(scene, 1, 1).objects[0].mesh->triangles == all);
}
