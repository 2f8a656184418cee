// The one question of this program: on which side of a half-space does this lie?
//
// A half-space is a plane and the side where the signed distance is not negative. "inside iff >= 0"
// everywhere; a room that decides ties differently (the fill rule) says so where it does.
#pragma once

#include <glm/vec4.hpp>

namespace hs::math {

/// The half-space a·x + b·y + c·z + d·w >= 0.
struct HalfSpace {
    float a = 0.0F;
    float b = 0.0F;
    float c = 0.0F;
    float d = 0.0F;
};

/// Not normalized: a distance scaled by the length of (a, b, c) and by w. Sign and ratios are what
/// clipping needs.
[[nodiscard]] inline float signed_distance(const HalfSpace& h, const glm::vec4& p) {
    return ((h.a * p.x + h.b * p.y) + h.c * p.z) + h.d * p.w;
}

[[nodiscard]] inline bool inside(float signed_distance) {
    return signed_distance >= 0.0F;
}

} // namespace hs::math
