// Sutherland and Hodgman, Reentrant Polygon Clipping, 1974, in homogeneous clip space (Blinn and
// Newell, Clipping Using Homogeneous Coordinates, 1978).
//
// Differs: a new vertex is always computed from the inside vertex toward the outside one, so that
// the two triangles sharing an edge compute the same vertex whichever way they run along it.
#pragma once

#include "core/base/check.hpp"
#include "core/geometry/clip_volume.hpp"
#include "core/math/interpolate.hpp"
#include "core/math/varyings.hpp"

#include <array>

namespace hs::geometry {

/// A vertex before the divide, with what is interpolated.
struct ClipVertex {
    math::ClipPosition position;
    math::Varyings varyings;
};

/// A convex polygon. A triangle clipped by k planes has at most 3 + k vertices.
struct ClipPolygon {
    std::array<ClipVertex, 3 + max_clip_planes> vertices;
    int count = 0;

    [[nodiscard]] const ClipVertex& operator[](int i) const {
        return vertices[static_cast<unsigned>(i)];
    }
    void add(const ClipVertex& vertex) {
        HS_DCHECK(count < static_cast<int>(vertices.size()), "each plane adds at most one vertex");
        vertices[static_cast<unsigned>(count++)] = vertex;
    }
};

/// Where the edge from `in` (distance d_in >= 0) to `out` (d_out < 0) meets the plane: t = d_in /
/// (d_in − d_out).
[[nodiscard]] inline ClipVertex
intersect_edge(const ClipVertex& in, float d_in, const ClipVertex& out, float d_out) {
    const float t = d_in / (d_in - d_out);
    ClipVertex vertex;
    vertex.position = {
        math::interpolate(in.position.x, out.position.x, t),
        math::interpolate(in.position.y, out.position.y, t),
        math::interpolate(in.position.z, out.position.z, t),
        math::interpolate(in.position.w, out.position.w, t),
    };
    for (int i = 0; i < math::max_varyings; ++i) {
        vertex.varyings[i] = math::interpolate(in.varyings[i], out.varyings[i], t);
    }
    return vertex;
}

/// The part of a convex polygon inside one half-space, in the same order of vertices. Vertices on
/// the plane are inside.
[[nodiscard]] inline ClipPolygon
clip_against(const ClipPolygon& polygon, const math::HalfSpace& plane) {
    ClipPolygon result;
    for (int i = 0; i < polygon.count; ++i) {
        const ClipVertex& current = polygon[i];
        const ClipVertex& previous = polygon[i == 0 ? polygon.count - 1 : i - 1];
        const float d_current = math::signed_distance(plane, math::to_vec4(current.position));
        const float d_previous = math::signed_distance(plane, math::to_vec4(previous.position));

        // Entering or leaving the half-space makes a vertex on the plane; staying inside keeps the
        // current one
        if (math::inside(d_current)) {
            if (!math::inside(d_previous)) {
                result.add(intersect_edge(current, d_current, previous, d_previous));
            }
            result.add(current);
        } else if (math::inside(d_previous)) {
            result.add(intersect_edge(previous, d_previous, current, d_current));
        }
    }
    return result;
}

/// Clips against every plane that some vertex is outside of (`crossed`, the union of outcodes),
/// narrating each pass. Planes no vertex is outside of would return the polygon unchanged.
template <typename Trace>
[[nodiscard]] ClipPolygon
clip_polygon(ClipPolygon polygon, const ClipVolume& volume, Outcode crossed, Trace& trace) {
    for (int k = 0; k < volume.count && polygon.count > 0; ++k) {
        if ((static_cast<unsigned>(crossed) >> static_cast<unsigned>(k) & 1U) == 0) {
            continue;
        }
        ClipPolygon kept = clip_against(polygon, volume.planes[static_cast<unsigned>(k)]);
        trace.clipped(static_cast<ClipPlane>(k), polygon, kept);
        polygon = kept;
    }
    return polygon;
}

} // namespace hs::geometry
