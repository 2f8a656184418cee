// The order in which an eye sees the cells of an octree: the eighth it looks from first, then those
// behind one wall, behind two, and the opposite one.
//
// Meagher, 1982. Cells are in order for free; polygons of one leaf are compared by their planes, as
// in Newell, Newell and Sancha's tests, and where those go in circles the nearer center goes first,
// which may be wrong inside that leaf.
#pragma once

#include "core/visibility/octree.hpp"

#include <glm/vec4.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace hs::visibility {

struct OctreeWalk {
    std::vector<std::int32_t> stack; ///< cells still to enter, the next one last
    std::vector<std::int32_t> leaf;  ///< of the current leaf: polygons not yet emitted
    std::vector<std::int32_t> order;
    std::int32_t undecided = 0; ///< polygons emitted before one that may hide them
};

/// Leaves with more are ordered by their centers alone: comparing takes the cube of their number.
inline constexpr std::size_t max_compared = 64;

/// The eighth of a cell on the eye's side of all its walls.
[[nodiscard]] int octant_of_eye(const OctreeCell& cell, const glm::dvec4& eye);

/// Eighths from the eye's to the opposite one: no cell before one that is nearer.
[[nodiscard]] std::array<int, octants> octants_from(int octant);

/// Do the planes show that `a` cannot be hidden by `b`?
[[nodiscard]] bool
in_front(const Octree& tree, std::int32_t a, std::int32_t b, const glm::dvec4& eye);

/// Distance of a polygon's center from the eye; from an infinitely far one, measured along its
/// direction from the origin.
[[nodiscard]] double center_distance(const Octree& tree, std::int32_t i, const glm::dvec4& eye);

namespace octree_walk_steps {

using Kind = OrderEventKind;

/// The place in the leaf of a polygon that none of the others may hide; without one, the nearest
/// center's.
template <OrderSink<OctreeWalk> Sink>
[[nodiscard]] std::size_t find_unhidden(
    const Octree& tree, const glm::dvec4& eye, OctreeWalk& walk, std::int32_t cell, Sink& sink
) {
    std::int32_t hiding = -1;
    for (std::size_t i = 0; walk.leaf.size() <= max_compared && i < walk.leaf.size(); ++i) {
        const auto hides = [&](std::int32_t other) {
            const std::int32_t polygon = walk.leaf[i];
            if (other == polygon) {
                return false;
            }
            const bool clear = in_front(tree, polygon, other, eye);
            sink.order_step(
                {.kind = Kind::in_front,
                 .verdict = clear,
                 .polygon = polygon,
                 .other = other,
                 .node = cell},
                walk
            );
            return !clear;
        };
        const auto found = std::ranges::find_if(walk.leaf, hides);
        if (found == walk.leaf.end()) {
            return i;
        }
        hiding = *found;
    }
    const auto nearest = std::ranges::min_element(walk.leaf, {}, [&](std::int32_t polygon) {
        return center_distance(tree, polygon, eye);
    });
    ++walk.undecided;
    sink.order_step(
        {.kind = Kind::undecided, .polygon = *nearest, .other = hiding, .node = cell}, walk
    );
    return static_cast<std::size_t>(nearest - walk.leaf.begin());
}

template <OrderSink<OctreeWalk> Sink>
void emit_leaf(
    const Octree& tree, const glm::dvec4& eye, OctreeWalk& walk, std::int32_t cell, Sink& sink
) {
    walk.leaf = tree.cells[static_cast<std::size_t>(cell)].polygons;
    while (!walk.leaf.empty()) {
        const std::size_t place = find_unhidden(tree, eye, walk, cell, sink);
        const std::int32_t polygon = walk.leaf[place];
        walk.leaf.erase(walk.leaf.begin() + static_cast<std::ptrdiff_t>(place));
        walk.order.push_back(polygon);
        sink.order_step(
            {.kind = Kind::emit,
             .polygon = polygon,
             .node = cell,
             .place = static_cast<std::int32_t>(walk.order.size()) - 1},
            walk
        );
    }
}

} // namespace octree_walk_steps

/// Front to back. `eye` in world space; w = 0: the direction toward it, infinitely far away.
template <OrderSink<OctreeWalk> Sink>
[[nodiscard]] OctreeWalk walk_octree(const Octree& tree, const glm::dvec4& eye, Sink& sink) {
    OctreeWalk walk;
    if (!tree.cells.empty()) {
        walk.stack.push_back(0);
    }
    while (!walk.stack.empty()) {
        const std::int32_t index = walk.stack.back();
        walk.stack.pop_back();
        const OctreeCell& cell = tree.cells[static_cast<std::size_t>(index)];
        const std::array<int, octants> near_to_far = octants_from(octant_of_eye(cell, eye));
        for (int k = octants - 1; k >= 0; --k) {
            const int octant = near_to_far[static_cast<std::size_t>(k)];
            const std::int32_t child = cell.children[static_cast<std::size_t>(octant)];
            if (child >= 0) {
                walk.stack.push_back(child);
            }
        }
        sink.order_step(
            {.kind = OrderEventKind::enter_cell,
             .verdict = cell.leaf,
             .node = index,
             .value = static_cast<double>(cell.polygons.size())},
            walk
        );
        octree_walk_steps::emit_leaf(tree, eye, walk, index, sink);
    }
    return walk;
}

} // namespace hs::visibility
