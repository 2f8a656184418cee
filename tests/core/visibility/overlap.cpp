#include "core/visibility/overlap.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/visible_surfaces.hpp"

#include <cmath>

using namespace hs;
using tests::window_rectangle;
using tests::window_triangle;
using visibility::WindowPolygon;

namespace {

constexpr glm::dvec3 reach{100.0, 100.0, 1.0};

bool overlap(const WindowPolygon& a, const WindowPolygon& b) {
    const bool one = visibility::projections_overlap(a, b, reach);
    CHECK(visibility::projections_overlap(b, a, reach) == one); // whichever is asked first
    return one;
}

} // namespace

TEST_CASE("triangles whose boxes overlap may not", "[visibility]") {
    const auto low = window_triangle(0, {0, 0, 0}, {10, 0, 0}, {0, 10, 0});
    const auto high = window_triangle(1, {10, 10, 0}, {10, 1, 0}, {1, 10, 0});
    CHECK(visibility::gap(visibility::extents_of(low), visibility::extents_of(high), 0) < 0.0);
    CHECK_FALSE(overlap(low, high));
    CHECK(overlap(low, window_triangle(1, {10, 10, 0}, {9, 0, 0}, {0, 9, 0})));
}

TEST_CASE("depth and winding do not matter to projections", "[visibility]") {
    const auto a = window_triangle(0, {0, 0, 0}, {10, 0, 0.2}, {0, 10, 0.9});
    CHECK(overlap(a, window_triangle(1, {1, 1, 1}, {4, 1, 1}, {1, 4, 1})));
    CHECK(overlap(a, window_triangle(1, {1, 4, 1}, {4, 1, 1}, {1, 1, 1})));
}

TEST_CASE("polygons that share an edge, a part of one or a corner only touch", "[visibility]") {
    const auto a = window_rectangle(0, {0, 0}, {10, 10}, 0.5);
    CHECK_FALSE(overlap(a, window_rectangle(1, {10, 0}, {20, 10}, 0.5)));
    CHECK_FALSE(overlap(a, window_rectangle(1, {10, 3}, {20, 7}, 0.5)));
    CHECK_FALSE(overlap(a, window_rectangle(1, {10, 10}, {20, 20}, 0.5)));
    const double over_by_a_pixel_256th = 10.0 - 1.0 / 256.0;
    CHECK(overlap(a, window_rectangle(1, {over_by_a_pixel_256th, 3}, {20, 7}, 0.5)));
}

TEST_CASE("a polygon inside another overlaps it", "[visibility]") {
    CHECK(overlap(
        window_rectangle(0, {0, 0}, {10, 10}, 0.5), window_rectangle(1, {4, 4}, {5, 5}, 0.5)
    ));
}

TEST_CASE("a polygon seen edge-on overlaps nothing", "[visibility]") {
    const auto square = window_rectangle(0, {0, 0}, {10, 10}, 0.5);
    CHECK_FALSE(overlap(square, window_triangle(1, {1, 1, 0}, {8, 5, 0}, {8, 5, 1})));
    CHECK_FALSE(overlap(square, window_triangle(1, {1, 1, 0}, {5, 5, 0.5}, {9, 9, 1})));
    CHECK_FALSE(overlap(square, window_triangle(1, {3, 3, 0}, {3, 3, 0.5}, {3, 3, 1})));
}

TEST_CASE("the common region of two squares is their intersection", "[visibility]") {
    const auto region = visibility::common_region(
        window_rectangle(0, {0, 0}, {10, 10}, 0.5),
        window_rectangle(1, {6, 7}, {20, 20}, 0.5),
        reach
    );
    REQUIRE(region.size() == 4);
    for (const glm::dvec2& corner : region) {
        CHECK((corner.x == 6.0 || corner.x == 10.0));
        CHECK((corner.y == 7.0 || corner.y == 10.0));
    }
}
