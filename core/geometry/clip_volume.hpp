// The half-spaces a primitive must lie in to be drawn: the six sides of the view volume and up to
// two user planes, all in clip space, before the divide.
//
// OpenGL 4.6, section 13.7 (Primitive Clipping): −w <= x, y, z <= w. Direct3D's and the reversed
// convention: 0 <= z <= w.
#pragma once

#include "core/base/named.hpp"
#include "core/math/half_space.hpp"
#include "core/math/space.hpp"
#include "core/scene/settings.hpp"

#include <glm/mat4x4.hpp>

#include <array>
#include <cstdint>

namespace hs::geometry {

/// In the order they clip. Near comes first: after it no vertex has w < 0 (perspective).
enum class ClipPlane : std::uint8_t {
    near,
    far,
    left,
    right,
    bottom,
    top,
    user0,
    user1
};
inline constexpr int max_clip_planes = 8;

struct ClipVolume {
    std::array<math::HalfSpace, max_clip_planes> planes{};
    int count = 6; ///< 6 … 8
};

/// `projection` carries user planes from eye space to clip space; it must be invertible if there
/// are any.
ClipVolume clip_volume(const scene::Settings& settings, const glm::mat4& projection);

/// A bit per plane, set when the vertex lies outside it (Cohen and Sutherland).
using Outcode = std::uint8_t;

/// A NaN anywhere is outside everything: its distances are not >= 0.
[[nodiscard]] inline Outcode outcode(const ClipVolume& volume, const math::ClipPosition& p) {
    unsigned code = 0;
    for (int k = 0; k < volume.count; ++k) {
        const float distance =
            math::signed_distance(volume.planes[static_cast<unsigned>(k)], math::to_vec4(p));
        code |= static_cast<unsigned>(!math::inside(distance)) << static_cast<unsigned>(k);
    }
    return static_cast<Outcode>(code);
}

} // namespace hs::geometry

namespace hs {
template <>
std::span<const Named<geometry::ClipPlane>> names<geometry::ClipPlane>();
} // namespace hs
