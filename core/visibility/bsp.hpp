// Binary space partitioning: polygons sorted once, in space, for every eye there will be.
//
// Fuchs, Kedem and Naylor, On Visible Surface Generation by A Priori Tree Structures, 1980; the
// idea of planes that separate is Schumacker's, 1969. Differs: the tree is built with a stack of
// lists instead of recursion, so its depth may be the number of polygons; polygons without area
// split nothing and lie on every plane their list meets.
//
// A node's polygon is the splitter; polygons of its plane stay with it. Parts keep the plane they
// came with and lie on one side of every splitter above, so each node's list is shorter than its
// parent's by the splitter and longer by at most what it splits, and no polygon is split by the
// same plane twice: the tree is finite.
#pragma once

#include "core/scene/settings.hpp"
#include "core/visibility/order_trace.hpp"
#include "core/visibility/polygon_set.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace hs::visibility {

/// Which polygon of a list splits it: the first, any by a seed, or the one that splits fewest
/// others, of up to `max_candidates` spread over the list.
using Splitter = scene::BspSplitter;

/// Asking every polygon of a list would cost its square. Fuchs, Kedem and Naylor found that a few
/// candidates do nearly as well.
inline constexpr std::int32_t max_candidates = 8;

struct BspOptions {
    Splitter splitter = Splitter::first;
    std::uint64_t seed = 0; ///< `random` only
};

struct BspNode {
    WorldPlane plane;                   ///< of the splitter; front is its counter-clockwise side
    std::vector<std::int32_t> polygons; ///< on the plane: the splitter first
    std::int32_t parent = -1;
    std::int32_t front = -1; ///< −1: nothing there
    std::int32_t back = -1;
};

/// A list that is waiting to become a node.
struct BspList {
    std::vector<std::int32_t> polygons; ///< never empty
    std::int32_t parent = -1;
    Side side = Side::front; ///< of the parent's plane
};

struct BspTree {
    PolygonSet<math::WorldSpace> set;
    std::vector<BspNode> nodes;   ///< the root first; parents before children
    std::vector<BspList> waiting; ///< empty when the tree is complete
    std::uint64_t random = 0;     ///< state of the generator
    std::int32_t splits = 0;
};

/// SplitMix64 (Steele, Lea and Flood, 2014): the same numbers everywhere.
std::uint64_t next_random(std::uint64_t& state);

/// Places in a list of `count` polygons that are asked what they would split.
[[nodiscard]] std::vector<std::int32_t> candidate_places(std::int32_t count);

/// How many polygons of a list the plane of one would split.
[[nodiscard]] std::int32_t
count_splits(const BspTree& tree, std::span<const std::int32_t> list, std::int32_t splitter);

/// The first of a list that has an area; the first of all if none has.
[[nodiscard]] std::size_t first_with_area(const BspTree& tree, std::span<const std::int32_t> list);

namespace bsp_steps {

using Kind = OrderEventKind;

/// The place in a list of what splits it.
template <OrderSink<BspTree> Sink>
[[nodiscard]] std::size_t
choose_splitter(BspTree& tree, const BspList& list, Splitter splitter, Sink& sink) {
    const std::span<const std::int32_t> polygons{list.polygons};
    const std::size_t first = first_with_area(tree, polygons);
    if (splitter == Splitter::first) {
        return first;
    }
    if (splitter == Splitter::random) {
        const std::size_t place = next_random(tree.random) % polygons.size();
        return has_area(tree.set.plane(polygons[place])) ? place : first;
    }
    std::size_t best = first;
    std::int32_t fewest = -1; // none asked yet
    for (const std::int32_t place : candidate_places(static_cast<std::int32_t>(polygons.size()))) {
        const std::int32_t candidate = polygons[static_cast<std::size_t>(place)];
        if (!has_area(tree.set.plane(candidate))) {
            continue;
        }
        const std::int32_t splits = count_splits(tree, polygons, candidate);
        const bool better = fewest < 0 || splits < fewest;
        if (better) {
            fewest = splits;
            best = static_cast<std::size_t>(place);
        }
        sink.order_step(
            {.kind = Kind::candidate,
             .verdict = better,
             .polygon = candidate,
             .node = static_cast<std::int32_t>(tree.nodes.size()),
             .value = static_cast<double>(splits),
             .other_value = static_cast<double>(polygons.size())},
            tree
        );
    }
    return best;
}

/// Makes the splitter of a list a node and tells its parent.
template <OrderSink<BspTree> Sink>
void make_node(BspTree& tree, const BspList& list, std::int32_t splitter, Sink& sink) {
    const auto node = static_cast<std::int32_t>(tree.nodes.size());
    tree.nodes.push_back(
        {.plane = tree.set.plane(splitter), .polygons = {splitter}, .parent = list.parent}
    );
    if (list.parent >= 0) {
        BspNode& parent = tree.nodes[static_cast<std::size_t>(list.parent)];
        (list.side == Side::front ? parent.front : parent.back) = node;
    }
    sink.order_step(
        {.kind = Kind::make_node,
         .side = list.side,
         .polygon = splitter,
         .node = node,
         .place = list.parent,
         .value = static_cast<double>(list.polygons.size())},
        tree
    );
}

/// Puts one polygon of a list on its side of the newest node, or on both in two parts.
template <OrderSink<BspTree> Sink>
void distribute(BspTree& tree, std::int32_t polygon, BspList& front, BspList& back, Sink& sink) {
    BspNode& node = tree.nodes.back();
    const Side side = classify(node.plane, tree.set.polygon(polygon));
    if (side == Side::on) {
        node.polygons.push_back(polygon);
    } else if (side == Side::back) {
        back.polygons.push_back(polygon);
    } else {
        front.polygons.push_back(polygon);
    }
    sink.order_step(
        {.kind = Kind::classify, .side = side, .polygon = polygon, .node = front.parent}, tree
    );
    if (side == Side::spanning) {
        const std::int32_t part = split(tree.set, polygon, node.plane);
        back.polygons.push_back(part);
        ++tree.splits;
        sink.order_step(
            {.kind = Kind::split,
             .polygon = polygon,
             .other = node.polygons.front(),
             .node = front.parent,
             .place = part,
             .value = area(tree.set.polygon(polygon)),
             .other_value = area(tree.set.polygon(part))},
            tree
        );
    }
}

} // namespace bsp_steps

/// The polygons of the tree are those given, in their order, and then the parts cut from them.
template <OrderSink<BspTree> Sink>
[[nodiscard]] BspTree
build_bsp(std::vector<WorldPolygon> polygons, const BspOptions& options, Sink& sink) {
    namespace steps = bsp_steps;
    BspTree tree;
    tree.set = polygon_set(std::move(polygons));
    tree.random = options.seed;
    if (tree.set.size() > 0) {
        BspList all;
        for (std::int32_t i = 0; i < tree.set.size(); ++i) {
            all.polygons.push_back(i);
        }
        tree.waiting.push_back(std::move(all));
    }
    while (!tree.waiting.empty()) {
        const BspList list = std::move(tree.waiting.back());
        tree.waiting.pop_back();

        // Choose the splitter
        const std::size_t chosen = steps::choose_splitter(tree, list, options.splitter, sink);
        steps::make_node(tree, list, list.polygons[chosen], sink);

        // Classify the others, and split those that span its plane
        const auto node = static_cast<std::int32_t>(tree.nodes.size()) - 1;
        BspList front{.polygons = {}, .parent = node, .side = Side::front};
        BspList back{.polygons = {}, .parent = node, .side = Side::back};
        for (std::size_t i = 0; i < list.polygons.size(); ++i) {
            if (i != chosen) {
                steps::distribute(tree, list.polygons[i], front, back, sink);
            }
        }

        // Go on in front, then behind
        if (!back.polygons.empty()) {
            tree.waiting.push_back(std::move(back));
        }
        if (!front.polygons.empty()) {
            tree.waiting.push_back(std::move(front));
        }
    }
    return tree;
}

/// How often building will ask on which side of a plane a polygon lies, candidates included.
/// Extrapolated from trees of some of the polygons (growth.hpp): n² for a convex surface with
/// `first`, little more than n for triangles in no order, more where they penetrate each other.
[[nodiscard]] double
estimate_bsp(std::span<const WorldPolygon> polygons, const BspOptions& options);

} // namespace hs::visibility
