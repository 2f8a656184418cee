// What algorithms order that sort space itself: every triangle where it stands in the world.
#pragma once

#include "core/pipeline/draw_order.hpp"

#include <glm/vec4.hpp>

#include <optional>
#include <string>
#include <vector>

namespace hs::pipeline {

/// All triangles of the frame, whatever is seen of them: a tree serves every eye. Weights are those
/// of clip coordinates, which are linear in the world.
/// Precondition: no complaint from `complaint_about_world`.
std::vector<visibility::WorldPolygon> world_polygons(const Frame& frame);

/// Why the world's coordinates cannot be divided by planes: a vertex with w ≠ 1 has no place there.
std::optional<std::string> complaint_about_world(const Frame& frame);

/// The point that all lines of sight meet in, in the world: what projects to x = y = w = 0. Where
/// they are parallel its w is 0, and it is the direction toward the eye.
glm::dvec4 eye_in_world(const Frame& frame);

} // namespace hs::pipeline
