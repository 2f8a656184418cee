// Which triangles can be in view at all? Boxes around many of them are asked first.
//
// Clark, Hierarchical Geometric Models for Visible Surface Algorithms, 1976; planes that a box is
// inside of are not asked again below it (Assarsson and Möller, Optimized View Frustum Culling
// Algorithms for Bounding Boxes, 2000).
//
// A box wholly outside one plane is rejected; one inside all planes is accepted. What is not
// rejected need not be visible: a box outside a corner of the view volume may straddle two planes.
#pragma once

#include "core/math/half_space.hpp"
#include "core/visibility/box_tree.hpp"
#include "core/visibility/plane.hpp"

#include <glm/mat4x4.hpp>

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hs::visibility {

enum class BoxVerdict : std::uint8_t {
    outside, ///< every corner is outside the plane
    inside,  ///< every corner is inside
    straddling
};

/// One box against one plane: the signed distances of the corners farthest inside and outside.
struct BoxTest {
    BoxVerdict verdict = BoxVerdict::straddling;
    double farthest_inside = 0.0;
    double farthest_outside = 0.0;
};

/// Outside only beyond the plane's tolerance: a triangle whose vertices the pipeline, in float,
/// finds inside is never rejected.
[[nodiscard]] BoxTest test_box(const Extents& box, const WorldPlane& plane);

/// A plane of the view volume, in clip space, carried back to world space: inside is in front.
/// `reach` is that of the scene.
[[nodiscard]] WorldPlane world_plane(
    const math::HalfSpace& clip_plane, const glm::mat4& world_to_clip, const glm::dvec3& reach
);

enum class CullEventKind : std::uint8_t {
    enter,   ///< `node` is to be asked about the planes in `planes`
    ask,     ///< `test` of `node` against `plane`
    reject,  ///< `node` and the `triangles` below it are out of view
    accept,  ///< `node` and the `triangles` below it are inside every plane
    descend, ///< `node` straddles `planes`: both halves are asked about these
    keep     ///< `node` straddles and is a leaf: its `triangles` go to the pipeline
};

/// One bit per plane.
using PlaneSet = std::uint32_t;

struct CullEvent {
    CullEventKind kind = CullEventKind::enter;
    std::int32_t node = -1;
    std::int32_t plane = -1;
    PlaneSet planes = 0;
    std::int32_t triangles = 0;
    BoxTest test{};
};

struct CullVisit {
    std::int32_t node = 0;
    PlaneSet planes = 0; ///< an ancestor straddles
    friend bool operator==(const CullVisit&, const CullVisit&) = default;
};

struct FrustumCull {
    std::vector<CullVisit> stack;   ///< the next one last
    std::vector<std::int32_t> kept; ///< triangles for the pipeline; at the end in file order
    std::int64_t asked = 0;         ///< boxes against planes
    std::int64_t spared = 0;        ///< not asked, because an ancestor was inside
    std::int32_t rejected = 0;      ///< triangles
};

/// Takes the story; never steers.
template <typename Sink>
concept CullSink = requires(Sink sink, const CullEvent& event, const FrustumCull& state) {
    { sink.cull_step(event, state) } -> std::same_as<void>;
};

struct SilentCull {
    void cull_step(const CullEvent&, const FrustumCull&) {}
};

namespace frustum_steps {

/// Asks the planes one by one until the box is outside of one. Returns those it straddles, or
/// nothing where it is outside.
template <CullSink Sink>
[[nodiscard]] std::optional<PlaneSet> straddled(
    const BoxTree& tree,
    const CullVisit& visit,
    std::span<const WorldPlane> planes,
    FrustumCull& cull,
    Sink& sink
) {
    PlaneSet left = visit.planes;
    cull.spared += static_cast<int>(planes.size()) - std::popcount(visit.planes);
    for (std::size_t k = 0; k < planes.size(); ++k) {
        const PlaneSet bit = 1U << k;
        if ((visit.planes & bit) == 0) {
            continue;
        }
        const BoxTest test =
            test_box(tree.nodes[static_cast<std::size_t>(visit.node)].box, planes[k]);
        ++cull.asked;
        sink.cull_step(
            {.kind = CullEventKind::ask,
             .node = visit.node,
             .plane = static_cast<std::int32_t>(k),
             .planes = visit.planes,
             .test = test},
            cull
        );
        if (test.verdict == BoxVerdict::outside) {
            return std::nullopt;
        }
        if (test.verdict == BoxVerdict::inside) {
            left &= ~bit;
        }
    }
    return left;
}

/// Decides about a box from the planes it straddles.
template <CullSink Sink>
void decide(
    const BoxTree& tree,
    const CullVisit& visit,
    std::optional<PlaneSet> straddled,
    FrustumCull& cull,
    Sink& sink
) {
    const BoxNode& node = tree.nodes[static_cast<std::size_t>(visit.node)];
    CullEvent event{.node = visit.node, .planes = straddled.value_or(0), .triangles = node.count};
    if (!straddled) {
        event.kind = CullEventKind::reject;
        cull.rejected += node.count;
    } else if (*straddled != 0 && node.left >= 0) {
        event.kind = CullEventKind::descend;
        cull.stack.push_back({node.right, *straddled});
        cull.stack.push_back({node.left, *straddled});
    } else {
        event.kind = *straddled == 0 ? CullEventKind::accept : CullEventKind::keep;
        const auto first = tree.triangles.begin() + node.first;
        cull.kept.insert(cull.kept.end(), first, first + node.count);
    }
    sink.cull_step(event, cull);
}

} // namespace frustum_steps

/// Up to 31 planes, the inside of the view volume in front.
template <CullSink Sink>
[[nodiscard]] FrustumCull
cull_to_frustum(const BoxTree& tree, std::span<const WorldPlane> planes, Sink& sink) {
    FrustumCull cull;
    if (!tree.nodes.empty()) {
        cull.stack.push_back({0, (PlaneSet{1} << planes.size()) - 1});
    }
    while (!cull.stack.empty()) {
        const CullVisit visit = cull.stack.back();
        cull.stack.pop_back();
        sink.cull_step(
            {.kind = CullEventKind::enter,
             .node = visit.node,
             .planes = visit.planes,
             .triangles = tree.nodes[static_cast<std::size_t>(visit.node)].count},
            cull
        );
        const auto left = frustum_steps::straddled(tree, visit, planes, cull, sink);
        frustum_steps::decide(tree, visit, left, cull, sink);
    }
    std::ranges::sort(cull.kept);
    return cull;
}

} // namespace hs::visibility
