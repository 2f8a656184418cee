// The reasoning behind one decision of an ordering algorithm: its whole state right after it,
// obtained by running the algorithm again.
#pragma once

#include "core/pipeline/draw_order.hpp"
#include "core/visibility/bsp_walk.hpp"
#include "core/visibility/depth_sort.hpp"
#include "core/visibility/front_lists.hpp"
#include "core/visibility/octree_walk.hpp"
#include "core/visibility/painters.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <variant>

namespace hs::trace {

struct Recording;

/// A tree under construction or, once it is complete, being walked.
struct BspMoment {
    visibility::BspTree tree;
    visibility::BspWalk walk;
};
struct OctreeMoment {
    visibility::Octree tree;
    visibility::OctreeWalk walk;
};

/// The state of whichever algorithm ran.
using OrderState = std::variant<
    std::monostate,
    visibility::PaintersSort,
    visibility::FrontLists,
    visibility::DepthSort,
    BspMoment,
    OctreeMoment>;

struct OrderDetail {
    visibility::OrderEvent decision;
    OrderState state; ///< after the decision

    /// The polygons that the decision's numbers mean, in the window; empty for algorithms that
    /// order in the world.
    [[nodiscard]] std::span<const visibility::WindowPolygon> window_polygons() const;
    /// Likewise in the world.
    [[nodiscard]] std::span<const visibility::WorldPolygon> world_polygons() const;
    /// Which triangle the polygon of a number is, or was part of; nothing for −1.
    [[nodiscard]] std::optional<pipeline::OrderedPolygon> polygon(std::int32_t number) const;
};

/// Costs a run of the whole algorithm. Precondition: the recording has more decisions.
OrderDetail order_detail(const Recording& recording, std::uint32_t event);

} // namespace hs::trace
