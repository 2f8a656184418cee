#include "core/raster/sample_pattern.hpp"

#include "tests/support/catch.hpp"

#include <set>
#include <utility>

using namespace hs;
using namespace hs::raster;

TEST_CASE("the four samples lie where llvmpipe and Direct3D have them", "[unit][raster]") {
    const auto in_pixel = [](const SampleOffset& offset) {
        return std::pair{0.5 + offset.x / 256.0, 0.5 + offset.y / 256.0};
    };
    const std::span<const SampleOffset> four = sample_pattern(4);
    REQUIRE(four.size() == 4);
    CHECK(in_pixel(four[0]) == std::pair{0.375, 0.125});
    CHECK(in_pixel(four[1]) == std::pair{0.875, 0.375});
    CHECK(in_pixel(four[2]) == std::pair{0.125, 0.625});
    CHECK(in_pixel(four[3]) == std::pair{0.625, 0.875});
}

TEST_CASE("one sample is the pixel's center", "[unit][raster]") {
    REQUIRE(sample_pattern(1).size() == 1);
    CHECK(sample_pattern(1)[0] == SampleOffset{0, 0});
}

// "N rooks": no two samples share a row or a column of the pattern's own grid, so that nearly
// horizontal and nearly vertical edges take as many steps as there are samples.
TEST_CASE("no two samples share a row or a column", "[unit][raster]") {
    for (const int count : {2, 4, 8}) {
        const std::span<const SampleOffset> pattern = sample_pattern(count);
        REQUIRE(pattern.size() == static_cast<std::size_t>(count));
        std::set<std::int32_t> columns;
        std::set<std::int32_t> rows;
        for (const SampleOffset& offset : pattern) {
            columns.insert(offset.x);
            rows.insert(offset.y);
            CHECK(std::abs(offset.x) <= sample_reach);
            CHECK(std::abs(offset.y) <= sample_reach);
            CHECK(offset.x % (subpixel_scale / 16) == 0);
            CHECK(offset.y % (subpixel_scale / 16) == 0);
        }
        INFO(count << " samples");
        CHECK(columns.size() == pattern.size());
        CHECK(rows.size() == pattern.size());
    }
}
