// Which pixels a triangle covers, decided by us and by Mesa's llvmpipe: not one pixel may differ.
//
// The second test proves that the first can fail: every wrong rule that people implement differs on
// the same triangles.
#include "tests/support/catch.hpp"
#include "tests/support/mesa.hpp"
#include "tests/support/rasterized.hpp"
#include "tests/support/triangle_soup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace hs;

namespace {

struct Size {
    int width;
    int height;
    int batches; ///< of 24 triangles
};
constexpr std::array<Size, 5> sizes{{
    {256, 256, 2000},
    {255, 127, 3000},
    {100, 61, 4000},
    {64, 64, 3000},
    {17, 5, 1000},
}};

using Bits = std::vector<std::uint32_t>; ///< per pixel, bit k: triangle k covers it

/// 24 triangles of every kind. Those on a lattice stay exactly on it: w is a power of two.
std::vector<glm::vec4> batch(const PixelRect& image, tests::Random& random) {
    std::vector<glm::vec4> corners;
    for (std::uint32_t k = 0; k < peer::coverage_batch_size; ++k) {
        const auto kind = static_cast<tests::SoupKind>(random.below(tests::soup_kinds));
        const bool exact = !random.one_in(3) && kind != tests::SoupKind::anywhere;
        for (const glm::dvec2& window : tests::soup_triangle(kind, image, random)) {
            const float w = exact ? std::ldexp(1.0F, static_cast<int>(random.below(7)) - 3)
                                  : random.between(0.1F, 20.0F);
            corners.push_back(tests::clip_at(window, random.between(-0.9F, 0.9F), w, image));
        }
    }
    return corners;
}

/// Calls `compare(image, corners, Mesa's bits)` for every batch of every size.
template <typename Compare>
void for_all_batches(peer::Context& mesa, Compare&& compare) {
    tests::Random random(2024);
    for (const Size& size : sizes) {
        const PixelRect image{0, 0, size.width, size.height};
        for (int i = 0; i < size.batches; ++i) {
            const std::vector<glm::vec4> corners = batch(image, random);
            const peer::Coverage theirs =
                mesa.coverage(corners, {.width = size.width, .height = size.height});
            REQUIRE(theirs.error.empty());
            compare(image, corners, theirs.bits);
        }
    }
}

std::size_t at(PixelPos pixel, const PixelRect& image) {
    return static_cast<std::size_t>(pixel.y * image.x1 + pixel.x);
}

/// Through the pipeline's own functions.
void our_bits(Bits& bits, const PixelRect& image, const std::vector<glm::vec4>& corners) {
    const auto viewport = geometry::make_viewport(image, scene::DepthConvention::opengl);
    bits.assign(at({0, image.y1}, image), 0);
    for (std::size_t k = 0; 3 * k < corners.size(); ++k) {
        const auto window = tests::placed({&corners[3 * k], 3}, viewport);
        tests::rasterize(
            tests::setup_of(window, image),
            image,
            scene::TraversalKind::bounding_box,
            [&](PixelPos pixel, const raster::EdgeValues&) { bits[at(pixel, image)] |= 1U << k; }
        );
    }
}

std::int64_t differences(const Bits& ours, std::span<const std::uint32_t> theirs) {
    std::int64_t count = 0;
    if (!std::ranges::equal(ours, theirs)) {
        for (std::size_t i = 0; i < ours.size(); ++i) {
            count += __builtin_popcount(ours[i] ^ theirs[i]);
        }
    }
    return count;
}

// ---- a rasterizer whose rule can be chosen

struct Rule {
    const char* name;
    int subpixel_bits;
    double (*round)(double);
    bool bottom_owns_ties;
};

double half_even(double v) {
    return std::nearbyint(v);
}
double half_up(double v) {
    return std::floor(v + 0.5);
}
double down(double v) {
    return std::floor(v);
}

constexpr Rule right_rule{"ours", 8, half_even, false};
constexpr std::array<Rule, 5> wrong_rules{{
    {"halves round up", 8, half_up, false},
    {"snapping truncates", 8, down, false},
    {"bottom edges own their ties", 8, half_even, true},
    {"4 subpixel bits", 4, half_even, false},
    {"12 subpixel bits", 12, half_even, false},
}};

struct Line {
    std::int64_t a, b, c, bias;
    [[nodiscard]] std::int64_t at(std::int64_t x, std::int64_t y) const {
        return a * x + b * y + c + bias;
    }
};

/// One triangle by the textbook: three biased edge functions over the bounding box.
void rasterize_by(
    const Rule& rule,
    const std::array<geometry::WindowVertex, 3>& window,
    const PixelRect& image,
    std::uint32_t bit,
    Bits& bits
) {
    const std::int64_t one = std::int64_t{1} << rule.subpixel_bits;
    std::array<std::int64_t, 3> x{};
    std::array<std::int64_t, 3> y{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto snap = [&](float v) {
            return static_cast<std::int64_t>(
                rule.round(static_cast<double>(v - 0.5F) * static_cast<double>(one))
            );
        };
        x[k] = snap(window[k].window.x);
        y[k] = snap(window[k].window.y);
    }
    const std::int64_t area = (x[2] - x[0]) * (y[1] - y[0]) - (y[2] - y[0]) * (x[1] - x[0]);
    if (area == 0) {
        return;
    }
    const std::int64_t sign = area < 0 ? -1 : 1;
    std::array<Line, 3> lines{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const std::int64_t a = sign * (y[next] - y[k]);
        const std::int64_t b = -sign * (x[next] - x[k]);
        const bool owns = a > 0 || (a == 0 && (rule.bottom_owns_ties ? b < 0 : b > 0));
        lines[k] = {a * one, b * one, -(a * x[k] + b * y[k]), owns ? 0 : -1};
    }
    const auto [x0, x1] = std::ranges::minmax(x);
    const auto [y0, y1] = std::ranges::minmax(y);
    const std::int64_t last_x = std::min<std::int64_t>(image.x1 - 1, x1 / one + 1);
    const std::int64_t last_y = std::min<std::int64_t>(image.y1 - 1, y1 / one + 1);
    for (std::int64_t py = std::max<std::int64_t>(0, y0 / one - 1); py <= last_y; ++py) {
        for (std::int64_t px = std::max<std::int64_t>(0, x0 / one - 1); px <= last_x; ++px) {
            if ((lines[0].at(px, py) | lines[1].at(px, py) | lines[2].at(px, py)) >= 0) {
                bits[static_cast<std::size_t>(py * image.x1 + px)] |= bit;
            }
        }
    }
}

std::int64_t differences_by(
    const Rule& rule,
    const PixelRect& image,
    const std::vector<glm::vec4>& corners,
    std::span<const std::uint32_t> theirs
) {
    static Bits bits;
    bits.assign(theirs.size(), 0);
    const auto viewport = geometry::make_viewport(image, scene::DepthConvention::opengl);
    for (std::size_t k = 0; 3 * k < corners.size(); ++k) {
        const auto window = tests::placed({&corners[3 * k], 3}, viewport);
        rasterize_by(rule, window, image, 1U << k, bits);
    }
    return differences(bits, theirs);
}

} // namespace

TEST_CASE("every triangle covers exactly the pixels it covers in Mesa", "[oracle][raster]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    std::int64_t triangles = 0;
    std::int64_t covered = 0;
    std::int64_t wrong = 0;
    Bits bits;
    for_all_batches(*mesa, [&](const PixelRect& image, const auto& corners, const auto& theirs) {
        our_bits(bits, image, corners);
        wrong += differences(bits, theirs);
        triangles += static_cast<std::int64_t>(corners.size()) / 3;
        for (const std::uint32_t word : theirs) {
            covered += __builtin_popcount(word);
        }
    });
    INFO(triangles << " triangles, " << covered << " covered pixels");
    CHECK(triangles >= 200'000);
    CHECK(covered > 10'000'000);
    CHECK(wrong == 0);
}

TEST_CASE("Mesa tells every wrong coverage rule from the right one", "[oracle][raster]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    std::int64_t by_the_right_rule = 0;
    std::array<std::int64_t, wrong_rules.size()> wrong{};
    int batches = 0;
    for_all_batches(*mesa, [&](const PixelRect& image, const auto& corners, const auto& theirs) {
        if (batches++ % 4 != 0) {
            return; // a quarter of the set tells them apart already
        }
        by_the_right_rule += differences_by(right_rule, image, corners, theirs);
        for (std::size_t r = 0; r < wrong_rules.size(); ++r) {
            wrong[r] += differences_by(wrong_rules[r], image, corners, theirs);
        }
    });
    CHECK(by_the_right_rule == 0);
    for (std::size_t r = 0; r < wrong_rules.size(); ++r) {
        INFO(wrong_rules[r].name);
        CHECK(wrong[r] > 0);
    }
}
