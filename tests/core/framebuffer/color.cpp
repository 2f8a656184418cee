#include "core/framebuffer/color.hpp"

#include "tests/support/catch.hpp"

#include <limits>

using namespace hs;

TEST_CASE("colors beyond [0, 1] and not a number are clamped", "[framebuffer][color]") {
    const float inf = std::numeric_limits<float>::infinity();
    CHECK(framebuffer::to_unorm8(-0.1F) == 0);
    CHECK(framebuffer::to_unorm8(-inf) == 0);
    CHECK(framebuffer::to_unorm8(1.1F) == 255);
    CHECK(framebuffer::to_unorm8(inf) == 255);
    CHECK(framebuffer::to_unorm8(std::numeric_limits<float>::quiet_NaN()) == 0);
}

TEST_CASE("ties go to the even level", "[framebuffer][color]") {
    CHECK(framebuffer::to_unorm8(0.5F) == 128); // 127.5
    CHECK(framebuffer::to_unorm8(0.1F) == 26);  // 25.5, after rounding 0.1 to a float
    CHECK(framebuffer::to_unorm8(0.3F) == 76);  // 76.5
}

TEST_CASE("red is the lowest byte, alpha the highest", "[framebuffer][color]") {
    CHECK(framebuffer::pack({1.0F, 0.0F, 0.0F, 0.0F}) == 0x000000FFU);
    CHECK(framebuffer::pack({0.0F, 1.0F, 0.0F, 0.0F}) == 0x0000FF00U);
    CHECK(framebuffer::pack({0.0F, 0.0F, 1.0F, 0.0F}) == 0x00FF0000U);
    CHECK(framebuffer::pack({0.0F, 0.0F, 0.0F, 1.0F}) == 0xFF000000U);
    CHECK(framebuffer::unpack(0xFF000033U) == glm::vec4{0.2F, 0.0F, 0.0F, 1.0F});
}
