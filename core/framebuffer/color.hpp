// How colors are stored: 8 bits a channel or 32-bit float.
#pragma once

#include <glm/vec4.hpp>

#include <cstdint>

namespace hs::framebuffer {

/// Red in the lowest byte, alpha in the highest: bytes R G B A in memory on little-endian machines.
using Rgba8 = std::uint32_t;

/// v·255 rounded to nearest, ties to even; values outside [0, 1] and NaN are clamped (NaN to 0).
[[nodiscard]] inline std::uint32_t to_unorm8(float v) {
    // Adding 2^23 leaves no fraction bits: the sum is rounded by the hardware, to nearest, ties to
    // even
    constexpr float round_to_integer = 8388608.0F;
    const float positive = v > 0.0F ? v : 0.0F; // written so that NaN becomes 0
    const float clamped = positive < 1.0F ? positive : 1.0F;
    const float rounded = (clamped * 255.0F + round_to_integer) - round_to_integer;
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(rounded));
}

[[nodiscard]] inline Rgba8 pack(const glm::vec4& c) {
    return to_unorm8(c.r) | to_unorm8(c.g) << 8U | to_unorm8(c.b) << 16U | to_unorm8(c.a) << 24U;
}

[[nodiscard]] inline glm::vec4 unpack(Rgba8 c) {
    const auto channel = [c](unsigned shift) {
        return static_cast<float>(c >> shift & 0xFFU) / 255.0F;
    };
    return {channel(0), channel(8), channel(16), channel(24)};
}

} // namespace hs::framebuffer
