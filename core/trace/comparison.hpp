// What every traversal would spend on the same scene, or on one triangle of it: each is run, none
// is recorded. Every triangle is drawn whole, whatever an ordering makes of it.
#pragma once

#include "core/raster/cost.hpp"
#include "core/scene/scene.hpp"
#include "core/trace/recording.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace hs::trace {

struct TraversalCost {
    scene::TraversalKind traversal = scene::TraversalKind::brute_force;
    std::uint64_t fragments = 0; ///< covered pixels
    raster::Cost cost;
};

/// One triangle of a scene.
struct TriangleNumber {
    std::uint32_t object = 0;
    std::uint32_t triangle = 0; ///< of the object
};

/// In the order of the enumeration. Precondition: `only` exists.
std::vector<TraversalCost> compare_traversals(
    const std::shared_ptr<const scene::Scene>& scene, std::optional<TriangleNumber> only = {}
);

/// For one triangle of a recorded frame, whose vertices need not be shaded again however large its
/// mesh is. Precondition: the triangle exists.
std::vector<TraversalCost>
compare_traversals(const Recording& recording, const TriangleNumber& triangle);

} // namespace hs::trace
