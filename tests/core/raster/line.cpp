#include "core/raster/line_bresenham.hpp"
#include "core/raster/line_dda.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

using namespace hs;
using raster::LineSetup;
using raster::LineStep;

namespace {

constexpr PixelRect everywhere{-100000, -100000, 100000, 100000};

struct Walk : raster::SilentTraversal {
    std::vector<LineStep> steps;
    raster::Cost spent;
    void line_stepped(const LineStep& step) { steps.push_back(step); }
    void cost(const raster::Cost& more) { spent += more; }
};

enum class Algorithm {
    bresenham,
    dda
};

Walk walk(const LineSetup& line, Algorithm algorithm, const PixelRect& region = everywhere) {
    Walk result;
    std::vector<PixelPos> emitted;
    const auto emit = [&](PixelPos pixel) { emitted.push_back(pixel); };
    if (algorithm == Algorithm::bresenham) {
        raster::walk_bresenham(line, region, result, emit);
    } else {
        raster::walk_dda(line, region, result, emit);
    }
    REQUIRE(emitted.size() == result.steps.size());
    for (std::size_t i = 0; i < emitted.size(); ++i) {
        REQUIRE(emitted[i] == result.steps[i].pixel);
    }
    return result;
}

/// From center to center.
LineSetup between(PixelPos a, PixelPos b) {
    return raster::set_up_line(
        {a.x * subpixel_scale, a.y * subpixel_scale}, {b.x * subpixel_scale, b.y * subpixel_scale}
    );
}

std::set<std::pair<int, int>> pixels(const Walk& walk) {
    std::set<std::pair<int, int>> set;
    for (const LineStep& step : walk.steps) {
        set.emplace(step.pixel.x, step.pixel.y);
    }
    return set;
}

/// All lines from the origin to the rim of a square, and some elsewhere.
template <typename Check>
void for_many_lines(Check&& check) {
    constexpr int radius = 24;
    for (int x = -radius; x <= radius; ++x) {
        for (int y = -radius; y <= radius; ++y) {
            check(between({0, 0}, {x, y}));
        }
    }
    tests::Random random(12);
    for (int i = 0; i < 500; ++i) {
        const auto any = [&random] { return static_cast<int>(random.below(600)) - 300; };
        const PixelPos a{any(), any()};
        check(between(a, {any(), any()}));
    }
}

/// Across the line at `k` steps along it: n times the exact coordinate.
std::int64_t exact_across(const LineSetup& line, int k) {
    return std::int64_t{line.minor_step} * line.rise * k;
}

int across(const LineSetup& line, PixelPos pixel) {
    return line.steep ? pixel.x - line.first.x : pixel.y - line.first.y;
}

} // namespace

TEST_CASE(
    "a line begins in the pixel of one end and stops in that of the other", "[raster][line]"
) {
    for_many_lines([](const LineSetup& line) {
        for (const Algorithm algorithm : {Algorithm::bresenham, Algorithm::dda}) {
            const Walk w = walk(line, algorithm);
            REQUIRE(w.steps.size() == static_cast<std::size_t>(line.steps) + 1);
            CHECK(w.steps.front().pixel == line.first);
            CHECK(w.steps.back().pixel == line.last);
        }
    });
}

TEST_CASE("each pixel of a line touches the next, one per step along it", "[raster][line]") {
    for_many_lines([](const LineSetup& line) {
        for (const Algorithm algorithm : {Algorithm::bresenham, Algorithm::dda}) {
            const Walk w = walk(line, algorithm);
            for (std::size_t i = 1; i < w.steps.size(); ++i) {
                const int dx = std::abs(w.steps[i].pixel.x - w.steps[i - 1].pixel.x);
                const int dy = std::abs(w.steps[i].pixel.y - w.steps[i - 1].pixel.y);
                REQUIRE((line.steep ? dy : dx) == 1);
                REQUIRE((line.steep ? dx : dy) == (w.steps[i].moved ? 1 : 0));
            }
        }
    });
}

TEST_CASE(
    "Bresenham takes the pixel nearest to the exact line, of two as near the one with the smaller "
    "coordinate",
    "[raster][line]"
) {
    int ties = 0;
    for_many_lines([&ties](const LineSetup& line) {
        for (const LineStep& step : walk(line, Algorithm::bresenham).steps) {
            // Twice n times how far the exact line lies beyond the pixel's center
            const std::int64_t beyond = 2 * (exact_across(line, step.number) -
                                             std::int64_t{line.steps} * across(line, step.pixel));
            REQUIRE(beyond > -line.steps - (line.steps == 0 ? 1 : 0));
            REQUIRE(beyond <= line.steps);
            ties += line.steps > 0 && beyond == line.steps ? 1 : 0;
        }
    });
    CHECK(ties > 100);
}

TEST_CASE("a line and its reverse are the same pixels", "[raster][line]") {
    for_many_lines([](const LineSetup& line) {
        const LineSetup back = between(line.last, line.first);
        REQUIRE(
            pixels(walk(line, Algorithm::bresenham)) == pixels(walk(back, Algorithm::bresenham))
        );
    });
}

TEST_CASE("the error term is what the closed form says", "[raster][line]") {
    for_many_lines([](const LineSetup& line) {
        for (const LineStep& step : walk(line, Algorithm::bresenham).steps) {
            const std::int64_t j = raster::steps_across(line, step.number);
            const std::int64_t e = 2 * std::int64_t{line.rise} * (step.number + 1) -
                                   2 * std::int64_t{line.steps} * j - line.steps;
            REQUIRE(step.after == static_cast<double>(e));
        }
    });
}

TEST_CASE(
    "a walk that begins inside the line tells what the whole one tells there", "[raster][line]"
) {
    const PixelRect region{-7, -9, 11, 6};
    for_many_lines([&region](const LineSetup& line) {
        for (const Algorithm algorithm : {Algorithm::bresenham, Algorithm::dda}) {
            std::vector<LineStep> expected;
            for (const LineStep& step : walk(line, algorithm).steps) {
                if (region.contains(step.pixel)) {
                    expected.push_back(step);
                }
            }
            const Walk part = walk(line, algorithm, region);
            REQUIRE(part.steps.size() == expected.size());
            for (std::size_t i = 0; i < expected.size(); ++i) {
                REQUIRE(part.steps[i].pixel == expected[i].pixel);
                REQUIRE(part.steps[i].before == expected[i].before);
                REQUIRE(part.steps[i].after == expected[i].after);
                REQUIRE(part.steps[i].moved == expected[i].moved);
            }
            REQUIRE(part.spent.pixels == expected.size());
        }
    });
}

TEST_CASE(
    "the DDA takes another pixel only where the exact line comes as near to the middle as its sum "
    "has drifted",
    "[raster][line]"
) {
    int different = 0;
    for_many_lines([&different](const LineSetup& line) {
        const Walk a = walk(line, Algorithm::bresenham);
        const Walk b = walk(line, Algorithm::dda);
        for (std::size_t i = 0; i < a.steps.size(); ++i) {
            if (a.steps[i].pixel == b.steps[i].pixel) {
                continue;
            }
            ++different;
            const int k = a.steps[i].number;
            const double exact = static_cast<double>(exact_across(line, k)) / line.steps;
            const double from_middle = std::fabs(exact - std::floor(exact) - 0.5);
            // Each addition rounds a number below 1024 by at most 2^-15; the slope, 2^-25 relative
            const double drift = (k + 1) * (std::ldexp(1.0, -15) + std::ldexp(1.0, -25));
            REQUIRE(from_middle <= drift);
        }
    });
    CHECK(different > 20); // ties: they round to the larger coordinate
}

TEST_CASE("between two pixels, an end belongs to the right or lower one", "[raster][line]") {
    CHECK(raster::pixel_of({0, 0}) == PixelPos{0, 0});
    CHECK(raster::pixel_of({127, -128}) == PixelPos{0, 0});
    CHECK(raster::pixel_of({128, -129}) == PixelPos{1, -1});
}

TEST_CASE("a fragment's place along a line is its projection onto it", "[raster][line]") {
    const LineSetup line = between({0, 0}, {8, 4});
    CHECK(raster::fraction_along(line, {0, 0}) == 0.0F);
    CHECK(raster::fraction_along(line, {8, 4}) == 1.0F);
    CHECK(raster::fraction_along(line, {4, 2}) == 0.5F);
    // (2, 1) + (−1, 2)·s lies beside it
    CHECK(raster::fraction_along(line, {1, 3}) == 0.25F);
    CHECK(raster::fraction_along(line, {-3, 0}) == 0.0F);
    CHECK(raster::fraction_along(between({5, 5}, {5, 5}), {5, 5}) == 0.0F);
}
