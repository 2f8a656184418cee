// The planes through the eye and a triangle's edges in the space view, with the ray through the
// pixel that is asked.
#pragma once

#include "app/viewer/orbit_camera.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/space_map.hpp"

namespace hs::viewer {

/// Planes are drawn up to so many times the distance of their edge from the eye.
inline constexpr float planes_reach = 1.5F;

/// Nothing unless the playhead stands in homogeneous rasterization.
void draw_planes_through_eye(
    const Context& context, const OrbitCamera& camera, const SpaceMap& map
);

} // namespace hs::viewer
