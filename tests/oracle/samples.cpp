// Four samples a pixel against Mesa's llvmpipe, whose samples can be read one by one. No tolerance
// for coverage. (llvmpipe offers 4 samples and no other number.)
#include "core/framebuffer/framebuffer.hpp"
#include "core/raster/sample_coverage.hpp"
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
using raster::SampleOffset;

namespace {

constexpr int samples = 4;
using Pattern = std::array<SampleOffset, samples>;
using Bits = std::vector<std::uint32_t>; ///< per sample, bit k: triangle k covers it

struct Size {
    int width;
    int height;
    int batches; ///< of 24 triangles
};
constexpr std::array<Size, 4> sizes{{{128, 96, 800}, {100, 61, 900}, {64, 64, 900}, {17, 5, 300}}};

/// 24 triangles of every kind.
std::vector<glm::vec4> batch(const PixelRect& image, tests::Random& random) {
    std::vector<glm::vec4> corners;
    for (std::uint32_t k = 0; k < peer::coverage_batch_size; ++k) {
        const auto kind = static_cast<tests::SoupKind>(k % tests::soup_kinds);
        const float w = std::ldexp(1.0F, static_cast<int>(random.below(7)) - 3);
        for (const glm::dvec2& window : tests::soup_triangle(kind, image, random)) {
            corners.push_back(tests::clip_at(window, random.between(-0.9F, 0.9F), w, image));
        }
    }
    return corners;
}

/// Calls `compare(image, corners, Mesa's bits)` for every batch of every size.
template <typename Compare>
void for_all_batches(peer::Context& mesa, Compare&& compare) {
    tests::Random random(2025);
    for (const Size& size : sizes) {
        const PixelRect image{0, 0, size.width, size.height};
        for (int i = 0; i < size.batches; ++i) {
            const std::vector<glm::vec4> corners = batch(image, random);
            const peer::Coverage theirs = mesa.coverage(
                corners, {.width = size.width, .height = size.height, .samples = samples}
            );
            REQUIRE(theirs.error.empty());
            compare(image, corners, theirs.bits);
        }
    }
}

std::size_t first_sample(PixelPos pixel, const PixelRect& image) {
    return static_cast<std::size_t>((pixel.y * image.x1 + pixel.x) * samples);
}

std::vector<std::optional<raster::TriangleSetup>>
setups_of(const PixelRect& image, const std::vector<glm::vec4>& corners) {
    const auto viewport = geometry::make_viewport(image, scene::DepthConvention::opengl);
    std::vector<std::optional<raster::TriangleSetup>> setups;
    for (std::size_t k = 0; 3 * k < corners.size(); ++k) {
        setups.push_back(tests::setup_of(tests::placed({&corners[3 * k], 3}, viewport), image));
    }
    return setups;
}

/// Through the pipeline's own functions.
Bits our_bits(const PixelRect& image, const std::vector<glm::vec4>& corners) {
    Bits bits(first_sample({0, image.y1}, image));
    raster::SilentTraversal silent;
    const auto setups = setups_of(image, corners);
    for (std::size_t k = 0; k < setups.size(); ++k) {
        if (!setups[k]) {
            continue;
        }
        raster::visit_samples(
            *setups[k],
            raster::sample_steps(*setups[k], samples),
            raster::bounds_of_samples(*setups[k], samples, image),
            {},
            silent,
            [&](PixelPos pixel, const raster::EdgeValues&, raster::CoverageMask mask) {
                for (int s = 0; s < samples; ++s) {
                    bits[first_sample(pixel, image) + static_cast<std::size_t>(s)] |=
                        raster::has_sample(mask, s) ? 1U << k : 0U;
                }
            }
        );
    }
    return bits;
}

/// By the same rule at samples that lie elsewhere, every pixel asked.
Bits bits_at(
    const Pattern& pattern, const PixelRect& image, const std::vector<glm::vec4>& corners
) {
    Bits bits(first_sample({0, image.y1}, image));
    const auto setups = setups_of(image, corners);
    for (std::size_t k = 0; k < setups.size(); ++k) {
        for (int y = 0; setups[k] && y < image.y1; ++y) {
            for (int x = 0; x < image.x1; ++x) {
                for (std::size_t s = 0; s < pattern.size(); ++s) {
                    raster::EdgeValues e = setups[k]->evaluate({x, y});
                    for (unsigned i = 0; i < 3; ++i) {
                        const raster::EdgeFunction& edge = setups[k]->edges[i];
                        e[i] += edge.a * pattern[s].x + edge.b * pattern[s].y;
                    }
                    bits[first_sample({x, y}, image) + s] |= setups[k]->covers(e) ? 1U << k : 0U;
                }
            }
        }
    }
    return bits;
}

std::int64_t differences(const Bits& ours, std::span<const std::uint32_t> theirs) {
    std::int64_t count = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        count += __builtin_popcount(ours[i] ^ theirs[i]);
    }
    return count;
}

struct WrongPattern {
    const char* name;
    Pattern pattern;
};

std::array<WrongPattern, 5> wrong_patterns() {
    Pattern right{};
    std::ranges::copy(raster::sample_pattern(samples), right.begin());
    Pattern mirrored = right;
    Pattern upside_down = right;
    Pattern nudged = right;
    for (unsigned s = 0; s < samples; ++s) {
        mirrored[s].x = -right[s].x;
        upside_down[s].y = -right[s].y;
        nudged[s].x += 1; // 1/256 pixel
    }
    Pattern swapped = right;
    std::swap(swapped[1], swapped[2]);
    constexpr std::int32_t quarter = subpixel_scale / 4;
    const Pattern regular{
        {{-quarter, -quarter}, {quarter, -quarter}, {-quarter, quarter}, {quarter, quarter}}};
    return {
        {{"mirrored", mirrored},
         {"upside down", upside_down},
         {"1/256 pixel to the right", nudged},
         {"two samples swapped", swapped},
         {"a regular grid", regular}}};
}

} // namespace

TEST_CASE("every triangle covers exactly the samples it covers in Mesa", "[oracle][raster]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    std::int64_t triangles = 0;
    std::int64_t covered = 0;
    std::int64_t wrong = 0;
    for_all_batches(*mesa, [&](const PixelRect& image, const auto& corners, const auto& theirs) {
        wrong += differences(our_bits(image, corners), theirs);
        triangles += static_cast<std::int64_t>(corners.size()) / 3;
        for (const std::uint32_t word : theirs) {
            covered += __builtin_popcount(word);
        }
    });
    INFO(triangles << " triangles, " << covered << " covered samples");
    CHECK(triangles >= 60'000);
    CHECK(covered > 10'000'000);
    CHECK(wrong == 0);
}

TEST_CASE("Mesa tells every wrong sample pattern from the right one", "[oracle][raster]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    const auto patterns = wrong_patterns();
    std::array<std::int64_t, 5> wrong{};
    int batches = 0;
    for_all_batches(*mesa, [&](const PixelRect& image, const auto& corners, const auto& theirs) {
        if (image.x1 > 64 || batches++ % 12 != 0) {
            return; // few and small images tell them apart already
        }
        for (std::size_t p = 0; p < patterns.size(); ++p) {
            wrong[p] += differences(bits_at(patterns[p].pattern, image, corners), theirs);
        }
    });
    for (std::size_t p = 0; p < patterns.size(); ++p) {
        INFO(patterns[p].name);
        CHECK(wrong[p] > 0);
    }
}

// Every triangle has one color and one depth, no two the same depth: nothing but coverage and depth
// per sample decides, so every sample must agree.
TEST_CASE("every sample of a picture shows what it shows in Mesa", "[oracle][raster]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    tests::Random random(7);
    scene::Settings settings;
    settings.width = 64;
    settings.height = 48;
    settings.samples = samples;
    settings.clip_enabled = false;
    settings.depth_format = scene::DepthFormat::unorm24;
    for (int picture = 0; picture < 40; ++picture) {
        tests::Soup soup;
        for (std::uint32_t k = 0; k < 60; ++k) {
            const auto kind = static_cast<tests::SoupKind>(k % tests::soup_kinds);
            const float z = static_cast<float>((k * 37) % 61) / 64.0F - 0.5F;
            const glm::vec4 color{
                static_cast<float>(random.below(256)) / 255.0F,
                static_cast<float>(random.below(256)) / 255.0F,
                static_cast<float>(random.below(256)) / 255.0F,
                1.0F};
            for (const glm::dvec2& at : tests::soup_triangle(kind, settings.image(), random)) {
                soup.push_back({tests::clip_at(at, z, 1.0F, settings.image()), color});
            }
        }
        const peer::Image theirs =
            tests::drawn_by(*mesa, soup, settings, tests::Sides::do_not_clip);
        const tests::Drawing ours = tests::drawn(tests::soup_scene(soup, settings));
        std::int64_t wrong = 0;
        int largest_rounding = 0;
        for (int y = 0; y < settings.height; ++y) {
            for (int x = 0; x < settings.width; ++x) {
                const framebuffer::PixelSamples held = ours.target.samples({x, y});
                const auto pixel = static_cast<std::size_t>(y * settings.width + x);
                for (std::size_t s = 0; s < samples; ++s) {
                    const auto sample = static_cast<int>(s);
                    const framebuffer::Rgba8 color = framebuffer::pack(held[sample].color);
                    for (unsigned c = 0; c < 3; ++c) {
                        const std::uint32_t byte = color >> (8 * c) & 0xFFU;
                        wrong += byte != theirs.rgba8[(pixel * samples + s) * 4 + c] ? 1 : 0;
                    }
                }
                const framebuffer::Rgba8 resolved = framebuffer::pack(ours.target.color({x, y}));
                for (unsigned c = 0; c < 3; ++c) {
                    const int byte = static_cast<int>(resolved >> (8 * c) & 0xFFU);
                    largest_rounding =
                        std::max(largest_rounding, std::abs(byte - theirs.resolved[pixel * 4 + c]));
                }
            }
        }
        REQUIRE(wrong == 0);
        REQUIRE(largest_rounding <= 1); // OpenGL leaves rounding open
    }
}
