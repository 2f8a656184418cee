// Boxes around triangles, boxes around boxes: a hierarchy of bounding volumes.
//
// Clark, Hierarchical Geometric Models for Visible Surface Algorithms, 1976; halved at the median
// along the longest side, as in Kay and Kajiya, Ray Tracing Complex Scenes, 1986.
#pragma once

#include "core/visibility/overlap.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace hs::visibility {

struct BoxNode {
    Extents box{}; ///< around all triangles below
    std::int32_t parent = -1;
    std::int32_t left = -1; ///< −1: a leaf
    std::int32_t right = -1;
    std::int32_t first = 0; ///< place in the tree's list of triangles
    std::int32_t count = 0; ///< triangles below
};

struct BoxTree {
    std::vector<BoxNode> nodes;          ///< the root first; parents before children
    std::vector<std::int32_t> triangles; ///< those below a node stand together
};

/// Leaves hold up to `leaf_size` triangles.
[[nodiscard]] BoxTree build_boxes(std::span<const Extents> triangles, std::int32_t leaf_size);

} // namespace hs::visibility
