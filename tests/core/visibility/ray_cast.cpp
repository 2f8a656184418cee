#include "core/visibility/ray_cast.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace hs;
using visibility::Ray;
using visibility::RayCast;
using visibility::RayTriangle;
using visibility::SweepEvent;
using visibility::SweepEventKind;

namespace {

constexpr Ray down_the_axis{{0, 0, 0}, {0, 0, 10}};

RayTriangle wall_at(double z) {
    return {glm::dvec3{-1, -1, z}, {1, -1, z}, {0, 2, z}};
}

struct EventTrace {
    std::vector<SweepEvent> events;
    void sweep_step(const SweepEvent& event, const RayCast&) { events.push_back(event); }
};

} // namespace

TEST_CASE("the nearest hit is kept, whatever the order", "[visibility]") {
    const std::vector<RayTriangle> walls{wall_at(5), wall_at(3), wall_at(7), wall_at(20)};
    EventTrace trace;
    const RayCast cast = visibility::cast_ray(down_the_axis, walls, trace);
    CHECK(cast.nearest == 1);
    CHECK(cast.meeting.t == Approx(0.3));
    std::vector<std::pair<std::int32_t, bool>> kept;
    for (const SweepEvent& event : trace.events) {
        if (event.kind == SweepEventKind::keep) {
            kept.emplace_back(event.polygon, event.verdict);
        }
    }
    // Beyond the far plane nothing is hit
    CHECK(kept == std::vector<std::pair<std::int32_t, bool>>{{0, true}, {1, true}, {2, false}});
}

TEST_CASE(
    "a ray meets both sides of a triangle, not its plane outside, nor its edge", "[visibility]"
) {
    const RayTriangle wall = wall_at(5);
    CHECK(visibility::meet(down_the_axis, wall).hit);
    CHECK(visibility::meet(down_the_axis, {wall[0], wall[2], wall[1]}).hit);
    const visibility::RayMeeting beside = visibility::meet({{3, 0, 0}, {0, 0, 10}}, wall);
    CHECK_FALSE(beside.hit);
    CHECK(beside.t == Approx(0.5));
    CHECK_FALSE(visibility::meet({{0, 0, 5}, {1, 0, 0}}, wall).hit); // along the plane
    CHECK_FALSE(visibility::meet(down_the_axis, {wall[0], wall[0], wall[0]}).hit);
}

TEST_CASE("edges and vertices belong to a triangle of either winding", "[visibility]") {
    const glm::dvec3 a{0, 0, 4};
    const glm::dvec3 b{4, 0, 4};
    const glm::dvec3 c{0, 4, 4};
    // On every edge, at every vertex; and just outside
    const std::vector<glm::dvec2> on{{2, 0}, {0, 2}, {2, 2}, {0, 0}, {4, 0}, {0, 4}};
    const std::vector<glm::dvec2> outside{{2, -0.125}, {-0.125, 2}, {2.125, 2}};
    for (const RayTriangle& triangle : {RayTriangle{a, b, c}, RayTriangle{a, c, b}}) {
        for (const glm::dvec2& p : on) {
            CHECK(visibility::meet({{p, 0}, {0, 0, 8}}, triangle).hit);
        }
        for (const glm::dvec2& p : outside) {
            CHECK_FALSE(visibility::meet({{p, 0}, {0, 0, 8}}, triangle).hit);
        }
    }
}

TEST_CASE("weights make the point where the ray meets", "[visibility]") {
    tests::Random random(451);
    double worst = 0.0;
    int hits = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto point = [&] {
            return glm::dvec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        };
        const RayTriangle triangle{point(), point(), point()};
        const Ray ray{point(), point()};
        const visibility::RayMeeting meeting = visibility::meet(ray, triangle);
        if (meeting.hit) {
            const glm::dvec3 from_weights = meeting.weights.x * triangle[0] +
                                            meeting.weights.y * triangle[1] +
                                            meeting.weights.z * triangle[2];
            const glm::dvec3 along = ray.origin + meeting.t * ray.direction;
            // Where the ray grazes the plane, the point is as uncertain as the volumes
            const double grazing = std::fabs(glm::dot(
                glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]), ray.direction
            ));
            worst = std::max(worst, glm::length(from_weights - along) * grazing);
            ++hits;
        }
    }
    CHECK(hits > 500);
    CHECK(worst < 1.0e-14);
}

TEST_CASE("no ray slips between triangles that share an edge or a vertex", "[visibility]") {
    // A fan around the axis, rays through its edges and its center
    tests::Random random(452);
    int missed = 0;
    for (int round = 0; round < 2000; ++round) {
        std::vector<RayTriangle> fan;
        const glm::dvec3 center{random.between(-1, 1), random.between(-1, 1), 5};
        std::vector<glm::dvec3> rim;
        for (int k = 0; k < 7; ++k) {
            const double angle = 6.283185307179586 * k / 7.0;
            rim.push_back(
                center + glm::dvec3{3 * std::cos(angle), 3 * std::sin(angle), random.between(-1, 1)}
            );
        }
        for (std::size_t k = 0; k < rim.size(); ++k) {
            fan.push_back({center, rim[k], rim[(k + 1) % rim.size()]});
        }
        const glm::dvec3 eye{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        const auto t = static_cast<double>(random.one_in(10) ? 0.0F : random.between(0, 0.9F));
        const glm::dvec3 target = center + t * (rim[random.below(7)] - center);
        visibility::SilentSweep silent;
        const RayCast cast = visibility::cast_ray({eye, 2.0 * (target - eye)}, fan, silent);
        missed += cast.nearest < 0 ? 1 : 0;
    }
    CHECK(missed == 0);
}

TEST_CASE("rays run from the near plane to the far plane of the camera", "[visibility]") {
    const glm::dmat4 camera = glm::perspective(1.0, 1.5, 0.5, 20.0);
    const glm::dvec2 size{150, 100};
    for (const glm::dvec2& window : {glm::dvec2{75, 50}, {10.5, 20.5}, {149.5, 0.5}}) {
        const Ray ray = visibility::ray_through(window, size, glm::inverse(camera), {});
        CHECK(ray.origin.z == Approx(-0.5));
        CHECK((ray.origin + ray.direction).z == Approx(-20.0));
        // Every point of it lands on the same window position
        for (const double t : {0.0, 0.3, 1.0}) {
            const glm::dvec4 clip = camera * glm::dvec4{ray.origin + t * ray.direction, 1.0};
            CHECK((clip.x / clip.w + 1.0) * 0.5 * size.x == Approx(window.x));
            CHECK((1.0 - clip.y / clip.w) * 0.5 * size.y == Approx(window.y));
        }
    }
}

TEST_CASE("the estimate is a question for every pixel and triangle", "[visibility]") {
    CHECK(visibility::estimate_ray_cast(1920, 1080, 69451) == 1920.0 * 1080.0 * 69451.0);
}
