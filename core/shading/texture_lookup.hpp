// Nearest texture lookup: the texel whose square contains the texture coordinate.
#pragma once

#include "core/scene/texture.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace hs::shading {

struct TexelPos {
    int i = 0;
    int j = 0;
};

/// Repeats the image: u and u + 1 address the same texel. Not a number and infinity address texel
/// 0.
[[nodiscard]] inline int repeat_texel(float coordinate, int size) {
    const float fraction = coordinate - std::floor(coordinate);
    const float scaled = fraction * static_cast<float>(size);
    if (!(scaled >= 0.0F)) {
        return 0;
    }
    return std::min(static_cast<int>(scaled), size - 1); // fraction may round up to 1
}

[[nodiscard]] inline TexelPos nearest_texel(const scene::Texture& texture, const glm::vec2& uv) {
    return {repeat_texel(uv.x, texture.width), repeat_texel(uv.y, texture.height)};
}

[[nodiscard]] inline const glm::vec4&
sample_nearest(const scene::Texture& texture, const glm::vec2& uv) {
    const TexelPos texel = nearest_texel(texture, uv);
    return texture.texel(texel.i, texel.j);
}

} // namespace hs::shading
