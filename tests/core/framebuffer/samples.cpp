#include "core/framebuffer/samples.hpp"

#include "core/framebuffer/framebuffer.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

#include <cmath>

using namespace hs;
using namespace hs::framebuffer;
using scene::ColorFormat;

namespace {

glm::vec4 random_color(tests::Random& random) {
    return {
        random.between(0.0F, 1.0F),
        random.between(0.0F, 1.0F),
        random.between(0.0F, 1.0F),
        random.between(0.0F, 1.0F)};
}

} // namespace

TEST_CASE("samples that agree resolve to exactly what they hold", "[unit][framebuffer]") {
    tests::Random random(1);
    for (int i = 0; i < 3000; ++i) {
        const glm::vec4 color = random_color(random);
        for (const int count : {2, 4, 8}) {
            CHECK(resolve(uniform_samples(count, {color}), ColorFormat::rgba32f).color == color);
            const glm::vec4 stored = unpack(pack(color));
            CHECK(resolve(uniform_samples(count, {stored}), ColorFormat::rgba8).color == stored);
        }
    }
}

TEST_CASE("8-bit samples resolve to the integer average, ties to even", "[unit][framebuffer]") {
    tests::Random random(2);
    for (int i = 0; i < 20000; ++i) {
        PixelSamples samples;
        samples.count = 2 << random.below(3);
        double sum = 0.0;
        for (int s = 0; s < samples.count; ++s) {
            const std::uint32_t byte = random.below(256);
            samples[s].color = unpack(byte * 0x01010101U);
            sum += byte;
        }
        const double expected = std::nearbyint(sum / samples.count); // exact: a dyadic fraction
        const Rgba8 resolved = pack(resolve(samples, ColorFormat::rgba8).color);
        REQUIRE(resolved == static_cast<std::uint32_t>(expected) * 0x01010101U);
    }
}

TEST_CASE("a resolved pixel has the depth of its first sample", "[unit][framebuffer]") {
    PixelSamples samples = uniform_samples(4, {glm::vec4{1.0F}, 0.75F});
    samples[0].depth = 0.25F;
    CHECK(resolve(samples, ColorFormat::rgba8).depth == 0.25F);
}

TEST_CASE("a framebuffer keeps each pixel's samples apart", "[unit][framebuffer]") {
    for (const ColorFormat format : {ColorFormat::rgba8, ColorFormat::rgba32f}) {
        scene::Settings settings;
        settings.width = 3;
        settings.height = 2;
        settings.samples = 8;
        settings.color_format = format;
        settings.background = {0.5F, 0.25F, 0.125F, 1.0F};
        Framebuffer target(settings);
        const PixelSamples cleared = cleared_samples(settings);
        CHECK(target.samples({2, 1}) == cleared);

        tests::Random random(3);
        PixelSamples written = cleared;
        for (int s = 0; s < written.count; ++s) {
            written[s] = {unpack(pack(random_color(random))), random.between(0.0F, 1.0F)};
        }
        const std::uint64_t before = target.digest();
        target.set_samples({1, 1}, written);
        CHECK(target.samples({1, 1}) == written);
        CHECK(target.samples({0, 1}) == cleared);
        CHECK(target.samples({2, 1}) == cleared);
        CHECK(target.digest() != before);
    }
}
