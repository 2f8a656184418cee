#include "core/raster/derivatives.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>

using namespace hs;
using namespace hs::raster;

namespace {

/// A triangle with one varying beside the depth, and its exact values at any point.
struct Sloped {
    TriangleSetup setup;
    std::array<float, 3> depths{};
    std::array<float, 3> inv_w{};
    std::array<std::array<float, math::max_varyings>, 3> varyings{};
    bool perspective = false;

    [[nodiscard]] Interpolator interpolator() const {
        return Interpolator(
            {.depth0 = depths[0],
             .depth1 = depths[1],
             .depth2 = depths[2],
             .inv_w0 = inv_w[0],
             .inv_w1 = inv_w[1],
             .inv_w2 = inv_w[2],
             .varyings0 = varyings[0].data(),
             .varyings1 = varyings[1].data(),
             .varyings2 = varyings[2].data(),
             .varying_count = 4,
             .perspective = perspective}
        );
    }
    /// λ0, λ1, λ2 at a pixel's center and their change per pixel along x or y: closed form, double.
    [[nodiscard]] std::array<double, 3> weights(PixelPos p) const {
        const EdgeValues e = setup.evaluate(p);
        const auto area = static_cast<double>(setup.doubled_area);
        return {
            static_cast<double>(e[1]) / area,
            static_cast<double>(e[2]) / area,
            static_cast<double>(e[0]) / area};
    }
    [[nodiscard]] std::array<double, 3> slopes(bool along_x) const {
        const auto per_pixel = [&](unsigned k) {
            const std::int64_t slope = along_x ? setup.edges[k].a : setup.edges[k].b;
            return static_cast<double>(slope * subpixel_scale) /
                   static_cast<double>(setup.doubled_area);
        };
        return {per_pixel(1), per_pixel(2), per_pixel(0)};
    }
};

double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Sloped random_triangle(tests::Random& random, bool perspective) {
    Sloped result;
    result.perspective = perspective;
    std::int64_t area = 0;
    std::array<FixedPosition, 3> v{};
    while (std::abs(area) < 400 * 65536) { // gentle slopes: at least 200 pixels
        for (FixedPosition& p : v) {
            p = {
                static_cast<std::int32_t>(random.below(64 * 256)),
                static_cast<std::int32_t>(random.below(64 * 256))};
        }
        area = std::int64_t{v[2].x - v[0].x} * (v[1].y - v[0].y) -
               std::int64_t{v[2].y - v[0].y} * (v[1].x - v[0].x);
    }
    result.setup = set_up(v, area, {0, 0, 64, 64});
    for (unsigned k = 0; k < 3; ++k) {
        result.depths[k] = random.between(0.0F, 1.0F);
        result.inv_w[k] = random.between(0.25F, 1.0F);
        for (unsigned i = 0; i < 4; ++i) {
            result.varyings[k][i] = random.between(-1.0F, 1.0F);
        }
    }
    return result;
}

std::array<double, 3> values_of(const Sloped& t, unsigned varying) {
    return {
        static_cast<double>(t.varyings[0][varying]),
        static_cast<double>(t.varyings[1][varying]),
        static_cast<double>(t.varyings[2][varying])};
}

const auto everywhere = [](PixelPos) { return true; };

} // namespace

TEST_CASE("every pixel belongs to one block of four", "[unit][raster]") {
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 9; ++x) {
            const PixelPos origin = quad_origin({x, y});
            CHECK(origin.x % 2 == 0);
            CHECK(origin.y % 2 == 0);
            CHECK((x - origin.x == 0 || x - origin.x == 1));
            CHECK((y - origin.y == 0 || y - origin.y == 1));
            FragmentQuad quad;
            quad.origin = origin;
            CHECK(quad.pixel(quad.index({x, y})) == PixelPos{x, y});
        }
    }
}

// What is linear in the window has the same derivative everywhere: the plane's slope.
TEST_CASE("linear interpolation has the plane's slope as its derivatives", "[unit][raster]") {
    tests::Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const Sloped t = random_triangle(random, false);
        const PixelPos pixel{
            static_cast<int>(random.below(64)), static_cast<int>(random.below(64))};
        const FragmentQuad quad = make_quad(t.setup, t.interpolator(), pixel, everywhere);
        for (const Derivatives& d : {coarse_derivatives(quad), fine_derivatives(quad, pixel)}) {
            for (unsigned k = 0; k < 4; ++k) {
                const std::array<double, 3> values = values_of(t, k);
                // Weights reach 64 and carry an error of a few 2^-24 each
                constexpr double rounding = 64.0 * 16.0 / 16777216.0;
                const auto index = static_cast<int>(k);
                REQUIRE(
                    std::abs(static_cast<double>(d.ddx[index]) - dot(values, t.slopes(true))) <
                    rounding
                );
                REQUIRE(
                    std::abs(static_cast<double>(d.ddy[index]) - dot(values, t.slopes(false))) <
                    rounding
                );
            }
        }
    }
}

// v = n / q with n and q linear in the window: v' = (n' q − n q') / q², and the difference over one
// pixel is n'q − nq' over q(x) q(x + 1), by the quotient rule for differences: exact, not a limit.
TEST_CASE("perspective derivatives obey the quotient rule for differences", "[unit][raster]") {
    tests::Random random(2);
    int checked = 0;
    for (int i = 0; i < 4000; ++i) {
        const Sloped t = random_triangle(random, true);
        const PixelPos pixel{
            static_cast<int>(random.below(64)), static_cast<int>(random.below(64))};
        const FragmentQuad quad = make_quad(t.setup, t.interpolator(), pixel, everywhere);
        const Derivatives d = fine_derivatives(quad, pixel);
        const std::array<double, 3> inv_w{
            static_cast<double>(t.inv_w[0]),
            static_cast<double>(t.inv_w[1]),
            static_cast<double>(t.inv_w[2])};
        for (const bool along_x : {true, false}) {
            const PixelPos from =
                along_x ? PixelPos{quad.origin.x, pixel.y} : PixelPos{pixel.x, quad.origin.y};
            const double q = dot(inv_w, t.weights(from));
            const double dq = dot(inv_w, t.slopes(along_x));
            if (q < 0.2 || q + dq < 0.2) {
                continue; // near the horizon no rounding bound is worth stating
            }
            for (unsigned k = 0; k < 4; ++k) {
                std::array<double, 3> over_w = values_of(t, k);
                for (unsigned c = 0; c < 3; ++c) {
                    over_w[c] *= inv_w[c];
                }
                const double n = dot(over_w, t.weights(from));
                const double dn = dot(over_w, t.slopes(along_x));
                const double expected = (dn * q - n * dq) / (q * (q + dq));
                const float ours =
                    along_x ? d.ddx[static_cast<int>(k)] : d.ddy[static_cast<int>(k)];
                constexpr double rounding = 64.0 * 256.0 / 16777216.0;
                REQUIRE(std::abs(static_cast<double>(ours) - expected) < rounding);
                ++checked;
            }
        }
    }
    CHECK(checked > 10000);
}

TEST_CASE("a block's pixels that are not covered are its helpers", "[unit][raster]") {
    tests::Random random(3);
    const Sloped t = random_triangle(random, false);
    const FragmentQuad quad =
        make_quad(t.setup, t.interpolator(), {5, 4}, [](PixelPos p) { return p.x == 5; });
    CHECK(quad.origin == PixelPos{4, 4});
    CHECK(quad.helper == std::array{true, false, true, false});
}
