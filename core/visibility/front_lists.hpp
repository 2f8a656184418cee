// Painter's algorithm without a sort key: for every polygon the list of those in front of it and
// the number of those behind it. What has nothing undrawn behind it can be drawn.
//
// Kahn, Topological Sorting of Large Networks, 1962, over the relation "in front of" of Newell,
// Newell and Sancha's pairs. Cost: a test for every pair of polygons.
//
// Polygons that are in front of each other in a circle are never drawn, nor is what is in front of
// them. Polygons that penetrate each other are related by one point, and one of them is wrong.
#pragma once

#include "core/visibility/order_trace.hpp"
#include "core/visibility/overlap.hpp"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace hs::visibility {

/// The algorithm's table, one row per polygon, and what it has drawn.
struct FrontLists {
    std::vector<WindowPolygon> polygons;
    std::vector<std::vector<std::int32_t>> in_front; ///< each from the farthest to the nearest
    std::vector<std::int32_t> behind; ///< undrawn polygons behind this one; −1: it is drawn
    std::int32_t iterations = 0;
    std::vector<std::int32_t> order; ///< drawn so far
    std::vector<std::int32_t> stuck; ///< the end, unless empty: these can never be drawn
};

/// Which of two polygons hides the other, and by how much, where their projections overlap.
struct DepthRelation {
    bool overlap = false;
    double depth_a = 0.0; ///< at the corner of the common region where they differ most
    double depth_b = 0.0;
};

[[nodiscard]] DepthRelation
depth_relation(const WindowPolygon& a, const WindowPolygon& b, const glm::dvec3& reach);

/// Pairs that `front_lists` asks about: all of them.
[[nodiscard]] inline double estimate_front_lists(std::size_t polygons) {
    const auto n = static_cast<double>(polygons);
    return 0.5 * n * (n - 1.0);
}

namespace front_list_steps {

using Kind = OrderEventKind;

/// `nearer` enters the front list of `farther`.
template <OrderSink<FrontLists> Sink>
void enter(FrontLists& lists, std::int32_t farther, std::int32_t nearer, Sink& sink) {
    const auto depth = [&](std::int32_t i) {
        return extents_of(lists.polygons[static_cast<std::size_t>(i)]).high.z;
    };
    auto& list = lists.in_front[static_cast<std::size_t>(farther)];
    std::size_t place = list.size();
    while (place > 0 && depth(list[place - 1]) < depth(nearer)) {
        --place;
    }
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(place), nearer);
    const std::int32_t count = ++lists.behind[static_cast<std::size_t>(nearer)];
    sink.order_step(
        {.kind = Kind::list_in_front,
         .polygon = farther,
         .other = nearer,
         .place = static_cast<std::int32_t>(place),
         .value = static_cast<double>(count)},
        lists
    );
}

/// Asks one pair which of them is in front.
template <OrderSink<FrontLists> Sink>
void relate(
    FrontLists& lists, std::int32_t a, std::int32_t b, const glm::dvec3& reach, Sink& sink
) {
    const DepthRelation relation = depth_relation(
        lists.polygons[static_cast<std::size_t>(a)],
        lists.polygons[static_cast<std::size_t>(b)],
        reach
    );
    sink.order_step(
        {.kind = Kind::overlap, .verdict = relation.overlap, .polygon = a, .other = b}, lists
    );
    if (!relation.overlap) {
        return;
    }
    sink.order_step(
        {.kind = Kind::nearer,
         .verdict = relation.depth_a < relation.depth_b,
         .polygon = a,
         .other = b,
         .value = relation.depth_a,
         .other_value = relation.depth_b},
        lists
    );
    if (relation.depth_a < relation.depth_b) {
        enter(lists, b, a, sink);
    } else if (relation.depth_b < relation.depth_a) {
        enter(lists, a, b, sink);
    }
}

/// Draws one polygon: nothing in front of it has to wait for it any more.
template <OrderSink<FrontLists> Sink>
void draw(FrontLists& lists, std::int32_t polygon, Sink& sink) {
    lists.behind[static_cast<std::size_t>(polygon)] = -1;
    lists.order.push_back(polygon);
    sink.order_step(
        {.kind = Kind::emit,
         .polygon = polygon,
         .place = static_cast<std::int32_t>(lists.order.size()) - 1},
        lists
    );
    for (const std::int32_t other : lists.in_front[static_cast<std::size_t>(polygon)]) {
        const std::int32_t count = --lists.behind[static_cast<std::size_t>(other)];
        sink.order_step(
            {.kind = Kind::count_down,
             .polygon = other,
             .other = polygon,
             .value = static_cast<double>(count)},
            lists
        );
    }
}

} // namespace front_list_steps

/// Polygons that no counter lets go, in file order.
[[nodiscard]] std::vector<std::int32_t> undrawn(const FrontLists& lists);

/// Of the undrawn polygons those that are also in the way of an undrawn one: they lie on a cycle,
/// or between two.
[[nodiscard]] std::vector<bool> in_cycles(const FrontLists& lists);

/// Ties, overlapping polygons equally deep everywhere, are left to the order of the file.
template <OrderSink<FrontLists> Sink>
[[nodiscard]] FrontLists order_by_front_lists(std::vector<WindowPolygon> polygons, Sink& sink) {
    namespace steps = front_list_steps;
    using Kind = OrderEventKind;
    FrontLists lists;
    lists.polygons = std::move(polygons);
    lists.in_front.resize(lists.polygons.size());
    lists.behind.resize(lists.polygons.size());
    const auto count = static_cast<std::int32_t>(lists.polygons.size());
    const glm::dvec3 extent = reach(std::span<const WindowPolygon>{lists.polygons});

    // Ask every pair which is in front
    for (std::int32_t a = 0; a < count; ++a) {
        for (std::int32_t b = a + 1; b < count; ++b) {
            steps::relate(lists, a, b, extent, sink);
        }
    }

    while (lists.order.size() < lists.polygons.size()) {
        // Read all zeros at the start of the iteration
        std::vector<std::int32_t> zeros;
        for (std::int32_t i = 0; i < count; ++i) {
            if (lists.behind[static_cast<std::size_t>(i)] == 0) {
                zeros.push_back(i);
            }
        }
        if (zeros.empty()) {
            break;
        }
        ++lists.iterations;
        sink.order_step(
            {.kind = Kind::iteration,
             .place = lists.iterations,
             .value = static_cast<double>(zeros.size())},
            lists
        );
        for (const std::int32_t polygon : zeros) {
            steps::draw(lists, polygon, sink);
        }
    }

    // No zero is left: name what is stuck
    const std::vector<bool> cycles = in_cycles(lists);
    for (const std::int32_t polygon : undrawn(lists)) {
        lists.stuck.push_back(polygon);
        sink.order_step(
            {.kind = Kind::stuck,
             .verdict = cycles[static_cast<std::size_t>(polygon)],
             .polygon = polygon},
            lists
        );
    }
    return lists;
}

} // namespace hs::visibility
