#include "core/visibility/box_tree.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <numeric>

namespace hs::visibility {

namespace {

Extents box_around(std::span<const Extents> triangles, std::span<const std::int32_t> list) {
    Extents box = triangles[static_cast<std::size_t>(list.front())];
    for (const std::int32_t i : list) {
        const Extents& extents = triangles[static_cast<std::size_t>(i)];
        box.low = glm::min(box.low, extents.low);
        box.high = glm::max(box.high, extents.high);
    }
    return box;
}

int longest_axis(const Extents& box) {
    const glm::dvec3 sides = box.high - box.low;
    return sides.x >= sides.y && sides.x >= sides.z ? 0 : sides.y >= sides.z ? 1 : 2;
}

/// Sorts the lower half of the triangles of a node along an axis before the upper half.
void halve(std::span<const Extents> triangles, std::span<std::int32_t> list, int axis) {
    const auto middle = [&](std::int32_t i) {
        const Extents& extents = triangles[static_cast<std::size_t>(i)];
        return extents.low[axis] + extents.high[axis];
    };
    std::nth_element(
        list.begin(),
        list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2),
        list.end(),
        [&](std::int32_t a, std::int32_t b) {
            return middle(a) != middle(b) ? middle(a) < middle(b) : a < b; // the same everywhere
        }
    );
}

} // namespace

BoxTree build_boxes(std::span<const Extents> triangles, std::int32_t leaf_size) {
    HS_CHECK(leaf_size >= 1, "a leaf holds a triangle");
    BoxTree tree;
    tree.triangles.resize(triangles.size());
    std::iota(tree.triangles.begin(), tree.triangles.end(), 0);
    if (triangles.empty()) {
        return tree;
    }
    tree.nodes.push_back({.count = static_cast<std::int32_t>(triangles.size())});
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) { // children join at the end
        const std::int32_t first = tree.nodes[i].first;
        const std::int32_t count = tree.nodes[i].count;
        const std::span<std::int32_t> list{
            tree.triangles.begin() + first, static_cast<std::size_t>(count)};
        tree.nodes[i].box = box_around(triangles, list);
        if (count <= leaf_size) {
            continue;
        }
        halve(triangles, list, longest_axis(tree.nodes[i].box));
        const auto parent = static_cast<std::int32_t>(i);
        tree.nodes[i].left = static_cast<std::int32_t>(tree.nodes.size());
        tree.nodes[i].right = tree.nodes[i].left + 1;
        tree.nodes.push_back({.parent = parent, .first = first, .count = count / 2});
        tree.nodes.push_back(
            {.parent = parent, .first = first + count / 2, .count = count - count / 2}
        );
    }
    return tree;
}

} // namespace hs::visibility
