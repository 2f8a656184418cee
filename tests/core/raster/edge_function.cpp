#include "core/raster/edge_function.hpp"

#include "tests/support/catch.hpp"

using namespace hs;

TEST_CASE("an edge function is a x + b y + c, twice the triangle's area", "[raster]") {
    // From pixel center (1, 1) to (4, 1): a = 0, b = −3 pixels
    const raster::EdgeFunction e = raster::edge_through({256, 256}, {1024, 256}, false);
    CHECK(e == raster::EdgeFunction{0, -768, 768 * 256});
    CHECK(e({2, 1}) == 0);
    CHECK(e({2, 0}) == 3 * 65536); // one pixel above: twice the area of a 3 × 1 triangle
    CHECK(e({2, 3}) == -6 * 65536);
}

TEST_CASE("turning an edge around negates its function", "[raster]") {
    const FixedPosition p{17, -300};
    const FixedPosition q{-1000, 4711};
    const raster::EdgeFunction forth = raster::edge_through(p, q, false);
    const raster::EdgeFunction back = raster::edge_through(q, p, false);
    CHECK(back == raster::EdgeFunction{-forth.a, -forth.b, -forth.c});
    CHECK(raster::edge_through(p, q, true) == back);
}

TEST_CASE("top and left edges own their ties, others do not", "[raster][top-left]") {
    const auto owns = [](std::int64_t a, std::int64_t b) {
        return raster::EdgeFunction{a, b, 0}.owns_ties();
    };
    CHECK(owns(1, 0));        // left: interior to the right
    CHECK(owns(1, -5));       // left, slanted
    CHECK(owns(1, 5));        // left, slanted
    CHECK_FALSE(owns(-1, 0)); // right
    CHECK_FALSE(owns(-1, 5)); // right, slanted
    CHECK(owns(0, 1));        // top: horizontal, interior below
    CHECK_FALSE(owns(0, -1)); // bottom
}

TEST_CASE("of two opposite edges exactly one owns the ties", "[raster][top-left]") {
    for (int a = -3; a <= 3; ++a) {
        for (int b = -3; b <= 3; ++b) {
            if (a == 0 && b == 0) {
                continue; // no edge
            }
            const raster::EdgeFunction e{a, b, 0};
            const raster::EdgeFunction opposite{-a, -b, 0};
            CHECK(e.owns_ties() != opposite.owns_ties());
        }
    }
}

TEST_CASE("edge functions do not overflow within the snap limit", "[raster]") {
    constexpr std::int32_t far = (1 << 30) - 1;
    const raster::EdgeFunction e = raster::edge_through({-far, -far}, {far, far}, false);
    CHECK(e({0, 0}) == 0);
    CHECK(e({8191, 0}) == 2 * std::int64_t{far} * 8191 * 256);
}
