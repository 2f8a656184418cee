// A line segment against clip planes: Sutherland and Hodgman's step on two vertices. What it leaves
// is what Liang and Barsky (A New Concept and Method for Line Clipping, 1984) find as t_enter and
// t_leave.
#pragma once

#include "core/geometry/clip_polygon.hpp"

namespace hs::geometry {

/// The part inside one half-space: two vertices, or none. A new end is computed from the inside end
/// toward the outside one.
[[nodiscard]] inline ClipPolygon
clip_segment_against(const ClipPolygon& segment, const math::HalfSpace& plane) {
    const float d0 = math::signed_distance(plane, math::to_vec4(segment[0].position));
    const float d1 = math::signed_distance(plane, math::to_vec4(segment[1].position));
    ClipPolygon kept;
    if (!math::inside(d0) && !math::inside(d1)) {
        return kept;
    }
    kept.add(math::inside(d0) ? segment[0] : intersect_edge(segment[1], d1, segment[0], d0));
    kept.add(math::inside(d1) ? segment[1] : intersect_edge(segment[0], d0, segment[1], d1));
    return kept;
}

/// Clips against every plane that an end is outside of, narrating each pass.
template <typename Trace>
[[nodiscard]] ClipPolygon
clip_segment(ClipPolygon segment, const ClipVolume& volume, Outcode crossed, Trace& trace) {
    for (int k = 0; k < volume.count && segment.count > 0; ++k) {
        if ((static_cast<unsigned>(crossed) >> static_cast<unsigned>(k) & 1U) == 0) {
            continue;
        }
        const ClipPolygon kept =
            clip_segment_against(segment, volume.planes[static_cast<unsigned>(k)]);
        trace.clipped(static_cast<ClipPlane>(k), segment, kept);
        segment = kept;
    }
    return segment;
}

} // namespace hs::geometry
