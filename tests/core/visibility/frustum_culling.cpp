#include "core/visibility/frustum_culling.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/visible_surfaces.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <set>

using namespace hs;
using visibility::BoxTree;
using visibility::BoxVerdict;
using visibility::CullEvent;
using visibility::CullEventKind;
using visibility::Extents;
using visibility::FrustumCull;
using visibility::WorldPlane;
using visibility::WorldPolygon;

namespace {

/// −w <= x, y, z <= w.
constexpr std::array<math::HalfSpace, 6> clip_planes{
    math::HalfSpace{0, 0, 1, 1},
    math::HalfSpace{0, 0, -1, 1},
    math::HalfSpace{1, 0, 0, 1},
    math::HalfSpace{-1, 0, 0, 1},
    math::HalfSpace{0, 1, 0, 1},
    math::HalfSpace{0, -1, 0, 1}};

constexpr glm::dvec3 reach{2.0, 2.0, 2.0};

std::vector<WorldPlane> planes_of(const glm::mat4& world_to_clip) {
    std::vector<WorldPlane> planes;
    planes.reserve(clip_planes.size());
    for (const math::HalfSpace& plane : clip_planes) {
        planes.push_back(visibility::world_plane(plane, world_to_clip, reach));
    }
    return planes;
}

std::vector<Extents> boxes_of(const std::vector<WorldPolygon>& triangles) {
    std::vector<Extents> boxes;
    boxes.reserve(triangles.size());
    for (const WorldPolygon& triangle : triangles) {
        boxes.push_back(visibility::extents_of(triangle));
    }
    return boxes;
}

/// As the pipeline does it, in float: a bit per plane that the vertex is outside of.
unsigned outcode(const glm::dvec3& vertex, const glm::mat4& world_to_clip) {
    const glm::vec4 clip = world_to_clip * glm::vec4{glm::vec3{vertex}, 1.0F};
    unsigned code = 0;
    for (std::size_t k = 0; k < clip_planes.size(); ++k) {
        code |= math::inside(math::signed_distance(clip_planes[k], clip)) ? 0U : 1U << k;
    }
    return code;
}

struct Outcodes {
    unsigned all = ~0U; ///< outside of for every vertex
    unsigned any = 0;
};

Outcodes outcodes(const WorldPolygon& triangle, const glm::mat4& world_to_clip) {
    Outcodes codes;
    for (const auto& corner : triangle.corners) {
        const unsigned code = outcode(corner.position, world_to_clip);
        codes.all &= code;
        codes.any |= code;
    }
    return codes;
}

struct EventTrace {
    std::vector<CullEvent> events;
    void cull_step(const CullEvent& event, const FrustumCull&) { events.push_back(event); }
};

/// The triangles below a node.
std::span<const std::int32_t> below(const BoxTree& tree, const visibility::BoxNode& node) {
    return std::span{tree.triangles}.subspan(
        static_cast<std::size_t>(node.first), static_cast<std::size_t>(node.count)
    );
}

bool holds(const Extents& box, const Extents& inner) {
    return glm::min(inner.low, box.low) == box.low && glm::max(inner.high, box.high) == box.high;
}

bool inside_all(const WorldPolygon& triangle, std::span<const WorldPlane> planes) {
    return std::ranges::all_of(planes, [&](const WorldPlane& plane) {
        return std::ranges::all_of(triangle.corners, [&](const auto& corner) {
            return visibility::signed_distance(plane, corner.position) >= -1e-12;
        });
    });
}

glm::mat4 random_camera(tests::Random& random) {
    const auto within = [&](float size) {
        return glm::vec3{
            random.between(-size, size), random.between(-size, size), random.between(-size, size)};
    };
    const glm::mat4 view = glm::lookAt(within(2.0F), within(1.0F), glm::vec3{0.1F, 1.0F, 0.2F});
    return glm::perspective(random.between(0.2F, 1.5F), 1.5F, 0.1F, random.between(1.0F, 5.0F)) *
           view;
}

Extents box(double low, double high) {
    return {{low, low, low}, {high, high, high}};
}

} // namespace

TEST_CASE(
    "a box is outside, inside or astride a plane by its two extreme corners", "[visibility]"
) {
    const WorldPlane plane{.normal = {1, 1, 0}, .offset = -2.0}; // x + y >= 2
    const visibility::BoxTest test = visibility::test_box(box(0.0, 3.0), plane);
    CHECK(test.farthest_inside == 4.0);
    CHECK(test.farthest_outside == -2.0);
    CHECK(test.verdict == BoxVerdict::straddling);
    CHECK(visibility::test_box(box(-3.0, 0.5), plane).verdict == BoxVerdict::outside);
    CHECK(visibility::test_box(box(1.5, 3.0), plane).verdict == BoxVerdict::inside);
    CHECK(visibility::test_box(box(1.0, 3.0), plane).verdict == BoxVerdict::inside); // touches
    CHECK(visibility::test_box(box(0.0, 1.0), plane).verdict == BoxVerdict::straddling);
}

TEST_CASE("planes carried to world space have the same points inside", "[visibility]") {
    tests::Random random(431);
    int wrong = 0;
    int near = 0;
    for (int round = 0; round < 200; ++round) {
        const glm::mat4 camera = random_camera(random);
        const std::vector<WorldPlane> planes = planes_of(camera);
        for (int i = 0; i < 20; ++i) {
            const glm::dvec3 point{
                random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)};
            const unsigned code = outcode(point, camera);
            for (std::size_t k = 0; k < planes.size(); ++k) {
                const double distance = visibility::signed_distance(planes[k], point);
                const bool inside = (code >> k & 1U) == 0;
                near += std::fabs(distance) <= planes[k].tolerance ? 1 : 0;
                wrong +=
                    std::fabs(distance) > planes[k].tolerance && inside != (distance > 0.0) ? 1 : 0;
            }
        }
    }
    CHECK(wrong == 0);
    CHECK(near < 10); // the tolerance decides next to nothing
}

TEST_CASE("every box of a tree holds the triangles below it, each in one leaf", "[visibility]") {
    tests::Random random(432);
    for (const std::uint32_t count : {1U, 2U, 7U, 1000U}) {
        const auto boxes = boxes_of(tests::random_world_triangles(count, 0.3F, random));
        const BoxTree tree = visibility::build_boxes(boxes, 4);
        std::multiset<std::int32_t> in_leaves;
        int outside = 0;
        for (const visibility::BoxNode& node : tree.nodes) {
            for (const std::int32_t triangle : below(tree, node)) {
                outside += holds(node.box, boxes[static_cast<std::size_t>(triangle)]) ? 0 : 1;
                if (node.left < 0) {
                    in_leaves.insert(triangle);
                }
            }
        }
        CHECK(outside == 0);
        CHECK(in_leaves.size() == count);
        CHECK(std::set<std::int32_t>(in_leaves.begin(), in_leaves.end()).size() == count);
    }
    CHECK(visibility::build_boxes({}, 4).nodes.empty());
}

TEST_CASE("what is rejected has every vertex outside one plane", "[property][visibility]") {
    tests::Random random(433);
    visibility::SilentCull silent;
    int wrong = 0;
    std::int64_t rejected = 0;
    std::int64_t could_be = 0;
    for (int round = 0; round < 300; ++round) {
        const auto triangles =
            tests::random_world_triangles(200, random.between(0.02F, 0.5F), random);
        const glm::mat4 camera = random_camera(random);
        const BoxTree tree = visibility::build_boxes(boxes_of(triangles), 1);
        const FrustumCull cull = visibility::cull_to_frustum(tree, planes_of(camera), silent);
        rejected += cull.rejected;
        wrong += cull.kept.size() + static_cast<std::size_t>(cull.rejected) == 200 ? 0 : 1;
        for (std::int32_t i = 0; i < 200; ++i) {
            const bool out = outcodes(triangles[static_cast<std::size_t>(i)], camera).all != 0;
            const bool kept = std::ranges::binary_search(cull.kept, i);
            could_be += out ? 1 : 0;
            wrong += kept || out ? 0 : 1;
        }
    }
    CHECK(wrong == 0);
    CHECK(rejected > 10'000);
    CHECK(rejected > could_be * 8 / 10); // boxes are larger than triangles
}

TEST_CASE("what is accepted has every vertex inside all planes", "[property][visibility]") {
    tests::Random random(434);
    int wrong = 0;
    int accepted = 0;
    for (int round = 0; round < 100; ++round) {
        const auto triangles = tests::random_world_triangles(100, 0.1F, random);
        const glm::mat4 camera = random_camera(random);
        const auto planes = planes_of(camera);
        const BoxTree tree = visibility::build_boxes(boxes_of(triangles), 2);
        EventTrace trace;
        static_cast<void>(visibility::cull_to_frustum(tree, planes, trace));
        for (const CullEvent& event : trace.events) {
            if (event.kind != CullEventKind::accept) {
                continue;
            }
            const visibility::BoxNode& node = tree.nodes[static_cast<std::size_t>(event.node)];
            for (const std::int32_t triangle : below(tree, node)) {
                wrong += inside_all(triangles[static_cast<std::size_t>(triangle)], planes) ? 0 : 1;
                ++accepted;
            }
        }
    }
    CHECK(wrong == 0);
    CHECK(accepted > 500);
}

TEST_CASE("planes that a box is inside of are not asked below it", "[visibility]") {
    tests::Random random(435);
    const auto triangles = tests::random_world_triangles(1000, 0.05F, random);
    const BoxTree tree = visibility::build_boxes(boxes_of(triangles), 1);
    EventTrace trace;
    // An orthographic view of the half x > 0: one plane cuts, five do not
    const glm::mat4 camera = glm::ortho(0.0F, 3.0F, -3.0F, 3.0F, -3.0F, 3.0F);
    const FrustumCull cull = visibility::cull_to_frustum(tree, planes_of(camera), trace);
    for (const CullEvent& event : trace.events) {
        if (event.kind == CullEventKind::ask && event.node != 0) {
            CHECK(event.plane == 2);
        }
    }
    CHECK(cull.asked < 1000);
    CHECK(cull.spared == 5 * (cull.asked - 6));
    CHECK(cull.rejected > 300);
    CHECK(trace.events.front().kind == CullEventKind::enter);
}

TEST_CASE("one question rejects everything behind the eye", "[visibility]") {
    tests::Random random(436);
    const auto triangles = tests::random_world_triangles(1000, 0.05F, random);
    const BoxTree tree = visibility::build_boxes(boxes_of(triangles), 4);
    const glm::mat4 away = glm::perspective(1.0F, 1.0F, 0.1F, 10.0F) *
                           glm::lookAt(glm::vec3{0, 0, 2}, glm::vec3{0, 0, 3}, glm::vec3{0, 1, 0});
    visibility::SilentCull silent;
    const FrustumCull cull = visibility::cull_to_frustum(tree, planes_of(away), silent);
    CHECK(cull.asked == 1);
    CHECK(cull.rejected == 1000);
    CHECK(cull.kept.empty());
}
