#include "core/base/fixed.hpp"

#include "tests/support/catch.hpp"

#include <array>

using namespace hs;

TEST_CASE("pixel centers snap to whole pixels", "[base][snap]") {
    CHECK(snap(0.5F) == 0);
    CHECK(snap(1.5F) == 256);
    CHECK(snap(-0.5F) == -256);
    CHECK(snap(100.5F) == 25600);
}

TEST_CASE("a half of 1/256 pixel snaps to the even neighbor", "[base][snap]") {
    struct Row {
        float halves; ///< of 1/256 pixel, from a pixel center
        std::int32_t fixed;
    };
    constexpr std::array<Row, 9> rows{{
        {1.0F, 0},
        {3.0F, 2},
        {5.0F, 2},
        {7.0F, 4},
        {-1.0F, 0},
        {-3.0F, -2},
        {-5.0F, -2},
        {2.0F, 1},
        {-2.0F, -1},
    }};
    for (const Row& row : rows) {
        INFO(row.halves << " / 512 pixel");
        CHECK(snap(0.5F + row.halves / 512.0F) == row.fixed);
    }
}

TEST_CASE("what lies beside a half snaps to the nearer neighbor", "[base][snap]") {
    CHECK(snap(0.5F + 0.999F / 512.0F) == 0);
    CHECK(snap(0.5F + 1.001F / 512.0F) == 1);
    CHECK(snap(0.5F + 2.999F / 512.0F) == 1);
    CHECK(snap(0.5F + 3.001F / 512.0F) == 2);
}

TEST_CASE("snapped coordinates come back to pixels exactly", "[base][snap]") {
    int wrong = 0;
    for (std::int32_t fixed = -(1 << 22); fixed <= 1 << 22; fixed += 7) {
        wrong += snap(to_pixels(fixed)) == fixed ? 0 : 1;
    }
    CHECK(wrong == 0);
}
