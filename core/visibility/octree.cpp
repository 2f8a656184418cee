#include "core/visibility/octree.hpp"

#include "core/visibility/overlap.hpp"

#include <algorithm>
#include <numeric>

namespace hs::visibility {

OctreeCell root_cell(const PolygonSet<math::WorldSpace>& set) {
    Extents box = extents_of(set.polygons.front());
    for (const WorldPolygon& polygon : set.polygons) {
        const Extents extents = extents_of(polygon);
        box.low = glm::min(box.low, extents.low);
        box.high = glm::max(box.high, extents.high);
    }
    const glm::dvec3 sides = box.high - box.low;
    OctreeCell cell;
    cell.middle = 0.5 * (box.low + box.high);
    cell.half_side = 0.5 * std::max({sides.x, sides.y, sides.z});
    cell.polygons.resize(set.polygons.size());
    std::iota(cell.polygons.begin(), cell.polygons.end(), 0);
    return cell;
}

OctreeCell child_cell(const Octree& tree, std::int32_t parent, int octant) {
    const OctreeCell& above = tree.cells[static_cast<std::size_t>(parent)];
    OctreeCell cell;
    cell.half_side = 0.5 * above.half_side;
    cell.depth = above.depth + 1;
    cell.parent = parent;
    for (int axis = 0; axis < 3; ++axis) {
        const bool upper = (static_cast<unsigned>(octant) >> static_cast<unsigned>(axis) & 1U) != 0;
        cell.middle[axis] = above.middle[axis] + (upper ? cell.half_side : -cell.half_side);
    }
    return cell;
}

WorldPlane wall(const Octree& tree, std::int32_t cell, int axis) {
    WorldPlane plane;
    plane.normal[axis] = 1.0;
    plane.offset = -tree.cells[static_cast<std::size_t>(cell)].middle[axis];
    plane.tolerance = relative_tolerance * tree.set.reach[axis];
    return plane;
}

} // namespace hs::visibility
