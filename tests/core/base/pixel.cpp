#include "core/base/pixel.hpp"

#include "tests/support/catch.hpp"

using namespace hs;

TEST_CASE("a rectangle contains its first pixels and not its last bounds", "[base]") {
    const PixelRect rect{2, 3, 5, 7};
    CHECK(rect.width() == 3);
    CHECK(rect.height() == 4);
    CHECK(rect.contains({2, 3}));
    CHECK(rect.contains({4, 6}));
    CHECK_FALSE(rect.contains({5, 6}));
    CHECK_FALSE(rect.contains({4, 7}));
    CHECK_FALSE(rect.contains({1, 3}));
}

TEST_CASE("a rectangle turned inside out is empty and has no size", "[base]") {
    const PixelRect rect{5, 3, 2, 7};
    CHECK(rect.empty());
    CHECK(rect.width() == 0);
    CHECK_FALSE(rect.contains({3, 4}));
}

TEST_CASE("an intersection holds what both rectangles hold", "[base]") {
    const PixelRect a{0, 0, 6, 6};
    const PixelRect b{4, -2, 9, 3};
    const PixelRect both = intersect(a, b);
    for (int y = -3; y < 10; ++y) {
        for (int x = -3; x < 10; ++x) {
            REQUIRE(both.contains({x, y}) == (a.contains({x, y}) && b.contains({x, y})));
        }
    }
    CHECK(intersect(a, {7, 0, 9, 9}).empty());
}
