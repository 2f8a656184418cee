// What the framebuffer stores, over every value it can store and against exact arithmetic.
#include "core/framebuffer/color.hpp"
#include "core/framebuffer/depth.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"
#include "tests/support/soup_scene.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

using namespace hs;

namespace {

constexpr std::array unorms{scene::DepthFormat::unorm16, scene::DepthFormat::unorm24};

double steps_of(scene::DepthFormat format) {
    return format == scene::DepthFormat::unorm24 ? 16777215.0 : 65535.0;
}

/// Every float from `low` to `high`, both included, for positive bounds.
template <typename Visit>
void for_floats(float low, float high, Visit&& visit) {
    const auto last = std::bit_cast<std::uint32_t>(high);
    for (auto bits = std::bit_cast<std::uint32_t>(low); bits <= last; ++bits) {
        visit(std::bit_cast<float>(bits));
    }
}

} // namespace

TEST_CASE("every unorm depth has a float of its own, in order", "[property][depth]") {
    for (const scene::DepthFormat format : unorms) {
        const double steps = steps_of(format);
        std::int64_t wrong = 0;
        float previous = -1.0F;
        for (std::uint32_t n = 0; n <= static_cast<std::uint32_t>(steps); ++n) {
            const float stored = framebuffer::store_depth(
                static_cast<float>(static_cast<double>(n) / steps), format
            );
            const bool right = stored > previous && tests::raw_depth(stored, format) == n;
            wrong += right ? 0 : 1;
            previous = stored;
        }
        INFO(name_of(format));
        CHECK(wrong == 0);
        CHECK(previous == 1.0F);
    }
}

TEST_CASE("storing a stored depth changes nothing", "[property][depth]") {
    for (const scene::DepthFormat format : unorms) {
        const double steps = steps_of(format);
        std::int64_t wrong = 0;
        for (std::uint32_t n = 0; n <= static_cast<std::uint32_t>(steps); ++n) {
            const auto value = static_cast<float>(static_cast<double>(n) / steps);
            wrong += framebuffer::store_depth(value, format) == value ? 0 : 1;
        }
        INFO(name_of(format));
        CHECK(wrong == 0);
    }
}

/// Exact: a float times 2^24 − 1 has at most 48 bits, a double holds 53.
TEST_CASE("depth is stored as the nearest unorm", "[property][depth]") {
    tests::Random random(91);
    for (const scene::DepthFormat format : unorms) {
        const double steps = steps_of(format);
        std::int64_t wrong = 0;
        for (int i = 0; i < 2'000'000; ++i) {
            const int halvings = random.one_in(4) ? static_cast<int>(random.below(30)) : 0;
            const float depth = std::ldexp(random.between(0.0F, 1.0F), -halvings);
            const float stored = framebuffer::store_depth(depth, format);
            const double exact = static_cast<double>(depth) * steps;
            const double off =
                std::fabs(static_cast<double>(tests::raw_depth(stored, format)) - exact);
            wrong += off <= 0.5 ? 0 : 1;
        }
        INFO(name_of(format));
        CHECK(wrong == 0);
    }
}

TEST_CASE("a farther depth is never stored as a nearer one", "[property][depth]") {
    for (const scene::DepthFormat format :
         {scene::DepthFormat::unorm16, scene::DepthFormat::unorm24, scene::DepthFormat::float32}) {
        std::int64_t wrong = 0;
        for (const float around : {1.0e-6F, 0.001F, 0.25F, 0.4999F, 0.9F}) {
            float previous = 0.0F;
            for_floats(around, around * 1.01F, [&](float depth) {
                const float stored = framebuffer::store_depth(depth, format);
                wrong += stored >= previous ? 0 : 1;
                previous = stored;
            });
        }
        INFO(name_of(format));
        CHECK(wrong == 0);
    }
}

/// The product v·255 is a float. Where it rounds to a tie between two levels, the even one is taken
/// although v·255 lay a little beside: 128 floats, one next to every other boundary, and none of
/// them by more than half of the product's last bit.
TEST_CASE("a color channel is stored as the nearest of 256 levels", "[property][color]") {
    std::int64_t beside = 0;
    double farthest = 0.0;
    for (int level = 0; level < 255; ++level) {
        const auto boundary = static_cast<float>((level + 0.5) / 255.0);
        for_floats(boundary * 0.9999F, boundary * 1.0001F, [&](float v) {
            const double exact = static_cast<double>(v) * 255.0;
            const double stored = framebuffer::to_unorm8(v);
            beside += stored == std::nearbyint(exact) ? 0 : 1;
            farthest = std::max(farthest, std::fabs(stored - exact));
        });
    }
    CHECK(beside == 128);
    CHECK(farthest <= 0.5 + 0x1p-17);
}

TEST_CASE("every packed color survives unpacking and packing", "[property][color]") {
    int wrong = 0;
    for (std::uint32_t value = 0; value < 256; ++value) {
        for (unsigned shift = 0; shift < 32; shift += 8) {
            const framebuffer::Rgba8 packed = value << shift | (255U - value) << (shift + 8) % 32;
            wrong += framebuffer::pack(framebuffer::unpack(packed)) == packed ? 0 : 1;
        }
    }
    CHECK(wrong == 0);
}
