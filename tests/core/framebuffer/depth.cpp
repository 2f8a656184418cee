#include "core/framebuffer/depth.hpp"

#include "core/base/named.hpp"
#include "tests/support/catch.hpp"

#include <limits>

using namespace hs;

TEST_CASE("depth beyond [0, 1] and not a number is clamped", "[framebuffer][depth]") {
    const float inf = std::numeric_limits<float>::infinity();
    for (const Named<scene::DepthFormat>& format : names<scene::DepthFormat>()) {
        INFO(format.name);
        const auto stored = [&](float depth) {
            return framebuffer::store_depth(depth, format.value);
        };
        CHECK(stored(-0.5F) == 0.0F);
        CHECK(stored(-inf) == 0.0F);
        CHECK(stored(0.0F) == 0.0F);
        CHECK(stored(1.0F) == 1.0F);
        CHECK(stored(1.5F) == 1.0F);
        CHECK(stored(inf) == 1.0F);
        CHECK(stored(std::numeric_limits<float>::quiet_NaN()) == 0.0F);
    }
}

TEST_CASE("float depth is stored as it is", "[framebuffer][depth]") {
    for (const float depth : {0.1F, 1.0e-30F, 0.99999994F}) {
        CHECK(framebuffer::store_depth(depth, scene::DepthFormat::float32) == depth);
    }
}

TEST_CASE("16 bits cannot tell depths closer than 1/65535", "[framebuffer][depth]") {
    const auto stored = [](float depth) {
        return framebuffer::store_depth(depth, scene::DepthFormat::unorm16);
    };
    CHECK(stored(0.5F) == stored(0.500005F));
    CHECK(stored(0.5F) != stored(0.50002F));
}
