#include "core/visibility/front_lists.hpp"

#include <algorithm>

namespace hs::visibility {

namespace {

/// The depth of a polygon above a window position, never outside its own depths: a plane seen
/// nearly edge-on may be anywhere a rounding away from its polygon.
double depth_within(const WindowPlane& plane, const Extents& extents, const glm::dvec2& position) {
    const std::optional<double> depth = depth_at(plane, position.x, position.y);
    return std::clamp(depth.value_or(extents.high.z), extents.low.z, extents.high.z);
}

} // namespace

DepthRelation
depth_relation(const WindowPolygon& a, const WindowPolygon& b, const glm::dvec3& reach) {
    DepthRelation relation;
    const Extents extents_a = extents_of(a);
    const Extents extents_b = extents_of(b);
    if (gap(extents_a, extents_b, 0) >= 0.0 || gap(extents_a, extents_b, 1) >= 0.0) {
        return relation;
    }
    const std::vector<glm::dvec2> region = common_region(a, b, reach);
    const WindowPlane plane_a = plane_of(a, reach);
    const WindowPlane plane_b = plane_of(b, reach);
    for (const glm::dvec2& position : region) {
        const double depth_a = depth_within(plane_a, extents_a, position);
        const double depth_b = depth_within(plane_b, extents_b, position);
        if (!relation.overlap ||
            std::fabs(depth_a - depth_b) > std::fabs(relation.depth_a - relation.depth_b)) {
            relation = {true, depth_a, depth_b};
        }
    }
    if (std::fabs(relation.depth_a - relation.depth_b) <= relative_tolerance * reach.z) {
        relation.depth_b = relation.depth_a; // one surface, but for rounding
    }
    return relation;
}

std::vector<std::int32_t> undrawn(const FrontLists& lists) {
    std::vector<std::int32_t> result;
    for (std::size_t i = 0; i < lists.behind.size(); ++i) {
        if (lists.behind[i] >= 0) {
            result.push_back(static_cast<std::int32_t>(i));
        }
    }
    return result;
}

std::vector<bool> in_cycles(const FrontLists& lists) {
    // Take away what has nothing undrawn in front of it, until all that is left is in the way of
    // something: the algorithm itself, from the near end
    const std::size_t count = lists.polygons.size();
    std::vector<bool> left(count);
    std::vector<std::int32_t> waiting(count); // undrawn polygons in front
    std::vector<std::vector<std::int32_t>> behind(count);
    for (const std::int32_t i : undrawn(lists)) {
        left[static_cast<std::size_t>(i)] = true;
        for (const std::int32_t nearer : lists.in_front[static_cast<std::size_t>(i)]) {
            behind[static_cast<std::size_t>(nearer)].push_back(i);
            ++waiting[static_cast<std::size_t>(i)];
        }
    }
    std::vector<std::int32_t> free;
    for (std::size_t i = 0; i < count; ++i) {
        if (left[i] && waiting[i] == 0) {
            free.push_back(static_cast<std::int32_t>(i));
        }
    }
    while (!free.empty()) {
        const auto i = static_cast<std::size_t>(free.back());
        free.pop_back();
        left[i] = false;
        for (const std::int32_t farther : behind[i]) {
            if (--waiting[static_cast<std::size_t>(farther)] == 0) {
                free.push_back(farther);
            }
        }
    }
    return left;
}

} // namespace hs::visibility
