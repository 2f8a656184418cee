// What clipping did to a triangle, plane by plane, in numbers people can follow.
#pragma once

#include "core/scene/settings.hpp"
#include "core/trace/detail.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace hs::explain {

/// What the outcodes alone decide (Cohen and Sutherland).
enum class OutcodeVerdict : std::uint8_t {
    accepted, ///< no vertex is outside of any plane
    rejected, ///< all vertices are outside of one plane
    undecided
};
OutcodeVerdict outcode_verdict(const std::array<geometry::Outcode, 3>& outcodes);

/// The planes whose bit is set, in the order they clip: "left, top".
std::string plane_names(geometry::Outcode outcode);

/// The distance to a plane as a formula: "w + x".
std::string_view plane_distance(geometry::ClipPlane plane, scene::DepthConvention convention);

/// An edge that a plane cuts: from its inside vertex to its outside vertex.
struct ClipCut {
    int inside = 0; ///< into the polygon before
    int outside = 0;
    float d_inside = 0.0F;
    float d_outside = 0.0F;
    float t = 0.0F; ///< d_in / (d_in − d_out)
    geometry::ClipVertex made;
};

/// One plane's pass over the polygon.
struct ClipPassStory {
    geometry::ClipPlane plane = geometry::ClipPlane::near;
    std::vector<float> distances; ///< of the vertices before
    std::vector<ClipCut> cuts;    ///< in the order of edges
};
std::vector<ClipPassStory>
clip_story(const trace::TriangleDetail& triangle, const scene::Settings& settings);

/// Why this triangle must be clipped before the divide, a sentence per vertex that lies at or
/// behind the eye; empty when no vertex does.
std::vector<std::string> reasons_to_clip(const trace::TriangleDetail& triangle);

} // namespace hs::explain
