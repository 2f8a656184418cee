// Merging a fragment's color with its pixel's: Porter and Duff, Compositing Digital Images, 1984,
// operator "over", with colors not multiplied by alpha beforehand (OpenGL:
// glBlendFuncSeparate(SRC_ALPHA, ONE_MINUS_SRC_ALPHA, ONE, ONE_MINUS_SRC_ALPHA)).
#pragma once

#include <glm/common.hpp>
#include <glm/vec4.hpp>

namespace hs::fragment {

/// src·a + dst·(1 − a); alpha: a + dst_a·(1 − a).
[[nodiscard]] inline glm::vec4 blend_over(const glm::vec4& src, const glm::vec4& dst) {
    const float keep = 1.0F - src.a;
    return {
        src.r * src.a + dst.r * keep,
        src.g * src.a + dst.g * keep,
        src.b * src.a + dst.b * keep,
        src.a + dst.a * keep,
    };
}

} // namespace hs::fragment
