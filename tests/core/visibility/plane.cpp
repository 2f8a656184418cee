#include "core/visibility/plane.hpp"

#include "core/visibility/split_polygon.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/visible_surfaces.hpp"

using namespace hs;
using visibility::Side;

namespace {

constexpr glm::dvec3 reach{4.0, 4.0, 4.0};

/// z = 1, front toward +z.
const auto wall = tests::world_triangle(0, {0, 0, 1}, {4, 0, 1}, {0, 4, 1});

Side side_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return visibility::classify(
        visibility::plane_of(wall, reach), tests::world_triangle(1, a, b, c)
    );
}

} // namespace

TEST_CASE("a polygon's plane has its counter-clockwise side in front", "[visibility]") {
    const auto plane = visibility::plane_of(wall, reach);
    CHECK(plane.normal == glm::dvec3{0, 0, 16});
    CHECK(visibility::signed_distance(plane, glm::dvec3{9, 9, 3}) == 32.0);
    CHECK(visibility::signed_distance(plane, glm::dvec4{0, 0, -1, 0}) == -16.0);
    CHECK(visibility::signed_distance(visibility::turned(plane), glm::dvec3{9, 9, 3}) == -32.0);
}

TEST_CASE("a triangle lies in front, behind, on or across a plane", "[visibility]") {
    CHECK(side_of({0, 0, 2}, {1, 0, 3}, {0, 1, 2}) == Side::front);
    CHECK(side_of({0, 0, 0}, {1, 0, -3}, {0, 1, 0}) == Side::back);
    CHECK(side_of({2, 2, 1}, {3, 2, 1}, {2, 3, 1}) == Side::on);
    CHECK(side_of({0, 0, 0}, {1, 0, 3}, {0, 1, 0}) == Side::spanning);
}

TEST_CASE("a corner or an edge on the plane takes no side", "[visibility]") {
    CHECK(side_of({0, 0, 1}, {1, 0, 3}, {0, 1, 2}) == Side::front);
    CHECK(side_of({0, 0, 1}, {1, 0, 1}, {0, 1, 0}) == Side::back);
}

TEST_CASE("what rounding to float moves off the plane is still on it", "[visibility]") {
    constexpr double half_ulp = 4.0 * 0x1p-24;
    CHECK(side_of({0, 0, 1 + half_ulp}, {1, 0, 1 - half_ulp}, {0, 1, 1}) == Side::on);
    CHECK(side_of({0, 0, 1 + 16 * half_ulp}, {1, 0, 1}, {0, 1, 1}) == Side::front);
}

TEST_CASE("the tolerance does not depend on the unit of an axis", "[visibility]") {
    // The same triangles, with z measured in thousandths
    const glm::dvec3 unit{1.0, 1.0, 1000.0};
    const auto plane = visibility::plane_of(
        tests::world_triangle(
            0, unit * glm::dvec3{0, 0, 1}, unit * glm::dvec3{4, 0, 1}, unit * glm::dvec3{0, 4, 1}
        ),
        unit * reach
    );
    for (const double z : {1 + 0x1p-21, 1 + 0x1p-19}) {
        const auto scaled = tests::world_triangle(
            1, unit * glm::dvec3{0, 0, z}, unit * glm::dvec3{1, 0, 1}, unit * glm::dvec3{0, 1, 1}
        );
        CHECK(visibility::classify(plane, scaled) == side_of({0, 0, z}, {1, 0, 1}, {0, 1, 1}));
    }
}

TEST_CASE("everything lies on the plane of a polygon without area", "[visibility]") {
    const auto line = tests::world_triangle(0, {0, 0, 0}, {1, 1, 1}, {3, 3, 3});
    const auto plane = visibility::plane_of(line, reach);
    CHECK_FALSE(visibility::has_area(plane));
    CHECK(visibility::classify(plane, wall) == Side::on);
}

TEST_CASE("a plane's depth is that of its polygon, and nothing edge-on", "[visibility]") {
    const auto ramp = tests::window_triangle(0, {0, 0, 0}, {10, 0, 1}, {0, 10, 0});
    const auto plane = visibility::plane_of(ramp, {10, 10, 1});
    CHECK(visibility::depth_at(plane, 5.0, 3.0).value() == Approx(0.5).epsilon(1e-15));
    const auto facing = visibility::facing_the_eye(plane);
    CHECK(visibility::signed_distance(facing, glm::dvec3{5, 3, -1}) > 0.0);
    const auto edge_on = tests::window_triangle(0, {0, 0, 0}, {10, 0, 1}, {5, 0, 1});
    CHECK_FALSE(visibility::depth_at(visibility::plane_of(edge_on, {10, 10, 1}), 5, 3).has_value());
}

TEST_CASE("splitting a triangle through a corner gives two triangles", "[visibility]") {
    const auto plane = visibility::plane_of(wall, reach);
    const auto halves =
        visibility::split_polygon(tests::world_triangle(1, {0, 0, 1}, {2, 0, 0}, {2, 0, 2}), plane);
    REQUIRE(halves.front.corners.size() == 3);
    REQUIRE(halves.back.corners.size() == 3);
    CHECK(halves.front.corners[1].position == glm::dvec3{2, 0, 1});
    CHECK(halves.front.corners[1].weights == glm::dvec3{0, 0.5, 0.5});
    CHECK(halves.back.corners[2] == halves.front.corners[1]);
    CHECK(halves.front.split);
}

TEST_CASE("splitting a triangle across two edges gives a triangle and a quad", "[visibility]") {
    const auto halves = visibility::split_polygon(
        tests::world_triangle(1, {0, 0, 2}, {2, 0, 0}, {2, 2, 0}), visibility::plane_of(wall, reach)
    );
    CHECK(halves.front.corners.size() == 3);
    CHECK(halves.back.corners.size() == 4);
}
