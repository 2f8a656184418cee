// An octree: space cut into eighths until few polygons are left in each cell, with the polygons cut
// at the walls. Cells, unlike polygons, are always in order.
//
// Meagher, Geometric Modeling Using Octree Encoding, 1982; with polygons in the leaves, as in
// Carlbom, Chakravarty and Vanderschel, 1985. Differs: polygons are cut at the walls, so each part
// lies in one leaf and none is met twice.
//
// Where polygons touch or penetrate, no cell is small enough to part them: depth is limited, and
// leaves hold several polygons (octree_walk.hpp orders those).
#pragma once

#include "core/visibility/order_trace.hpp"
#include "core/visibility/polygon_set.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace hs::visibility {

struct OctreeOptions {
    std::int32_t occupancy = 4;         ///< a cell with more polygons is divided …
    std::int32_t depth = 6;             ///< … unless it lies this deep; the root's depth is 0 …
    std::int32_t max_parts = 1'000'000; ///< … or there are this many polygons and parts
};

struct OctreeCell {
    glm::dvec3 middle{0.0};
    double half_side = 0.0;
    std::int32_t depth = 0;
    std::int32_t parent = -1;
    std::array<std::int32_t, 8> children{-1, -1, -1, -1, -1, -1, -1, -1}; ///< −1: empty
    bool leaf = true;
    std::vector<std::int32_t> polygons; ///< of a leaf
};

struct Octree {
    PolygonSet<math::WorldSpace> set;
    std::vector<OctreeCell> cells;     ///< the root first; parents before children
    std::vector<std::int32_t> waiting; ///< cells to look at; empty when the tree is complete
    std::int32_t splits = 0;
};

/// Bit k of an octant is set on the upper side of the wall across axis k. What lies in the wall
/// belongs to the upper side: inside iff >= 0.
inline constexpr int octants = 8;

/// The cube around all polygons.
[[nodiscard]] OctreeCell root_cell(const PolygonSet<math::WorldSpace>& set);

/// The eighth of a cell, without polygons.
[[nodiscard]] OctreeCell child_cell(const Octree& tree, std::int32_t parent, int octant);

/// Through the middle of a cell, the upper side in front.
[[nodiscard]] WorldPlane wall(const Octree& tree, std::int32_t cell, int axis);

namespace octree_steps {

using Kind = OrderEventKind;

/// Cuts the polygons of a cell at the wall across one axis; the parts join the list.
template <OrderSink<Octree> Sink>
void cut_at_wall(
    Octree& tree, std::int32_t cell, int axis, std::vector<std::int32_t>& polygons, Sink& sink
) {
    const WorldPlane plane = wall(tree, cell, axis);
    const std::size_t count = polygons.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::int32_t polygon = polygons[i];
        if (classify(plane, tree.set.polygon(polygon)) != Side::spanning) {
            continue;
        }
        const std::int32_t part = split(tree.set, polygon, plane);
        polygons.push_back(part);
        ++tree.splits;
        sink.order_step(
            {.kind = Kind::split,
             .axis = static_cast<std::int8_t>(axis),
             .polygon = polygon,
             .node = cell,
             .place = part,
             .value = area(tree.set.polygon(polygon)),
             .other_value = area(tree.set.polygon(part))},
            tree
        );
    }
}

/// On which side of each wall a polygon that spans none of them lies.
[[nodiscard]] inline int octant_of(const Octree& tree, std::int32_t cell, std::int32_t polygon) {
    unsigned octant = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Side side = classify(wall(tree, cell, axis), tree.set.polygon(polygon));
        octant |= side == Side::back ? 0U : 1U << static_cast<unsigned>(axis);
    }
    return static_cast<int>(octant);
}

/// Moves the polygons of a cell to its eighths; empty ones are not made.
template <OrderSink<Octree> Sink>
void divide(Octree& tree, std::int32_t cell, Sink& sink) {
    const auto index = static_cast<std::size_t>(cell);
    std::vector<std::int32_t> polygons = std::move(tree.cells[index].polygons);
    tree.cells[index].polygons.clear();
    tree.cells[index].leaf = false;
    for (int axis = 0; axis < 3; ++axis) {
        cut_at_wall(tree, cell, axis, polygons, sink);
    }
    std::array<std::vector<std::int32_t>, octants> parts;
    for (const std::int32_t polygon : polygons) {
        parts[static_cast<std::size_t>(octant_of(tree, cell, polygon))].push_back(polygon);
    }
    for (int octant = 0; octant < octants; ++octant) {
        const auto k = static_cast<std::size_t>(octant);
        if (!parts[k].empty()) {
            OctreeCell child = child_cell(tree, cell, octant);
            child.polygons = std::move(parts[k]);
            tree.cells[index].children[k] = static_cast<std::int32_t>(tree.cells.size());
            tree.waiting.push_back(tree.cells[index].children[k]);
            tree.cells.push_back(std::move(child));
        }
    }
}

} // namespace octree_steps

/// The polygons of the tree are those given, in their order, and then the parts cut from them.
template <OrderSink<Octree> Sink>
[[nodiscard]] Octree
build_octree(std::vector<WorldPolygon> polygons, const OctreeOptions& options, Sink& sink) {
    Octree tree;
    tree.set = polygon_set(std::move(polygons));
    if (tree.set.size() > 0) {
        tree.cells.push_back(root_cell(tree.set));
        tree.waiting.push_back(0);
    }
    while (!tree.waiting.empty()) {
        const std::int32_t cell = tree.waiting.back();
        tree.waiting.pop_back();
        const OctreeCell& looked_at = tree.cells[static_cast<std::size_t>(cell)];
        const auto count = static_cast<std::int32_t>(looked_at.polygons.size());
        const bool divided = count > options.occupancy && looked_at.depth < options.depth &&
                             tree.set.size() < options.max_parts;
        sink.order_step(
            {.kind = OrderEventKind::make_cell,
             .verdict = divided,
             .node = cell,
             .place = looked_at.parent,
             .value = static_cast<double>(count)},
            tree
        );
        if (divided) {
            octree_steps::divide(tree, cell, sink);
        }
    }
    return tree;
}

} // namespace hs::visibility
