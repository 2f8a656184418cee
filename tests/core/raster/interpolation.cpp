#include "core/raster/interpolation.hpp"

#include "core/geometry/facing.hpp"
#include "tests/support/catch.hpp"

#include <array>

using namespace hs;

namespace {

/// At the middle of the edge from vertex 0 (w = 1, value 0) to vertex 1 (w = 3, value 1).
raster::Fragment middle_of_edge(bool perspective) {
    const std::array<FixedPosition, 3> v{{{0, 0}, {0, 2048}, {2048, 0}}};
    const auto setup = raster::set_up(v, geometry::doubled_area(v[0], v[1], v[2]), {0, 0, 16, 16});
    constexpr std::array zero{0.0F};
    constexpr std::array one{1.0F};
    const raster::Interpolants in{
        .depth0 = 0.25F,
        .depth1 = 0.75F,
        .depth2 = 1.0F,
        .inv_w0 = 1.0F,
        .inv_w1 = 1.0F / 3.0F,
        .inv_w2 = 1.0F,
        .varyings0 = zero.data(),
        .varyings1 = one.data(),
        .varyings2 = zero.data(),
        .varying_count = 1,
        .perspective = perspective};
    return raster::interpolate(in, setup, {0, 4}, setup.evaluate({0, 4}));
}

} // namespace

TEST_CASE("halfway on screen is a quarter of the way to a vertex thrice as far", "[raster]") {
    const raster::Fragment f = middle_of_edge(true);
    CHECK(f.barycentric[1] == 0.5F);
    CHECK(f.barycentric_clip[1] == Approx(0.25F));
    CHECK(f.varyings[0] == Approx(0.25F));
}

TEST_CASE("linear interpolation ignores w", "[raster]") {
    const raster::Fragment f = middle_of_edge(false);
    CHECK(f.barycentric_clip[1] == 0.5F);
    CHECK(f.varyings[0] == 0.5F);
}

TEST_CASE("depth is linear on the screen either way", "[raster]") {
    CHECK(middle_of_edge(true).depth == 0.5F);
    CHECK(middle_of_edge(false).depth == 0.5F);
}

TEST_CASE("varyings beyond the count in use stay zero", "[raster]") {
    CHECK(middle_of_edge(true).varyings[1] == 0.0F);
}
