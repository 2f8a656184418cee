// Which way a triangle faces, from its snapped window vertices, and what culling makes of it.
#pragma once

#include "core/base/fixed.hpp"
#include "core/base/named.hpp"
#include "core/scene/settings.hpp"

#include <cstdint>

namespace hs::geometry {

/// Back and front facing are verdicts only where that side is culled.
enum class TriangleVerdict : std::uint8_t {
    drawn,
    outside,
    back_facing,
    front_facing,
    degenerate,
    no_sample_covered,
    behind_the_eye,
    too_large,
    stuck,
    unseen,
};

/// Twice the signed area in 1/65536 pixel², positive for triangles that are counterclockwise as
/// seen. Exact: raw coordinates fit 31 bits.
[[nodiscard]] inline std::int64_t
doubled_area(const FixedPosition& v0, const FixedPosition& v1, const FixedPosition& v2) {
    const std::int64_t x1 = std::int64_t{v1.x} - v0.x;
    const std::int64_t y1 = std::int64_t{v1.y} - v0.y;
    const std::int64_t x2 = std::int64_t{v2.x} - v0.x;
    const std::int64_t y2 = std::int64_t{v2.y} - v0.y;
    return x2 * y1 - y2 * x1;
}

[[nodiscard]] inline bool is_front(std::int64_t doubled_area, scene::Winding front_face) {
    return (doubled_area > 0) == (front_face == scene::Winding::ccw);
}

/// `drawn` when the triangle survives, else why not. Zero area is degenerate whatever is culled.
[[nodiscard]] inline TriangleVerdict
face_verdict(std::int64_t doubled_area, scene::Winding front_face, scene::CullFace cull) {
    if (doubled_area == 0) {
        return TriangleVerdict::degenerate;
    }
    const bool front = is_front(doubled_area, front_face);
    if (front && cull == scene::CullFace::front) {
        return TriangleVerdict::front_facing;
    }
    if (!front && cull == scene::CullFace::back) {
        return TriangleVerdict::back_facing;
    }
    return TriangleVerdict::drawn;
}

} // namespace hs::geometry

namespace hs {
template <>
std::span<const Named<geometry::TriangleVerdict>> names<geometry::TriangleVerdict>();
} // namespace hs
