// The polygons of an algorithm that splits, with their planes.
#pragma once

#include "core/base/check.hpp"
#include "core/visibility/split_polygon.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace hs::visibility {

/// A part keeps the plane of the polygon it was cut from: a plane computed from the corners of a
/// sliver would be worse, and a polygon is then cut by each plane at most once.
template <typename Space>
struct PolygonSet {
    std::vector<Polygon<Space>> polygons;
    std::vector<Plane<Space>> planes; ///< one per polygon
    glm::dvec3 reach{0.0};            ///< of what was given; parts stay within it
    std::vector<std::uint32_t> parts; ///< given out so far, per triangle

    [[nodiscard]] const Polygon<Space>& polygon(std::int32_t i) const {
        return polygons[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] const Plane<Space>& plane(std::int32_t i) const {
        return planes[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] std::int32_t size() const { return static_cast<std::int32_t>(polygons.size()); }
};

template <typename Space>
[[nodiscard]] PolygonSet<Space> polygon_set(std::vector<Polygon<Space>> polygons) {
    PolygonSet<Space> set;
    set.reach = reach(std::span<const Polygon<Space>>{polygons});
    for (const Polygon<Space>& polygon : polygons) {
        HS_DCHECK(polygon.corners.size() >= 3, "a polygon has an inside");
        set.planes.push_back(plane_of(polygon, set.reach));
        if (polygon.triangle >= set.parts.size()) {
            set.parts.resize(polygon.triangle + std::size_t{1});
        }
        set.parts[polygon.triangle] = std::max(set.parts[polygon.triangle], polygon.part + 1);
    }
    set.polygons = std::move(polygons);
    return set;
}

/// Cuts polygon `i` by a plane that it spans: `i` keeps the part in front, the part behind becomes
/// a new polygon. Returns its index.
template <typename Space>
std::int32_t split(PolygonSet<Space>& set, std::int32_t i, const Plane<Space>& plane) {
    const auto index = static_cast<std::size_t>(i);
    HS_DCHECK(set.polygons[index].triangle_count == 1, "only triangles can be cut");
    Halves<Space> halves = split_polygon(set.polygons[index], plane);
    halves.back.part = set.parts[halves.back.triangle]++;
    const Plane<Space> own = set.planes[index];
    set.polygons[index] = std::move(halves.front);
    set.polygons.push_back(std::move(halves.back));
    set.planes.push_back(own);
    return set.size() - 1;
}

} // namespace hs::visibility
