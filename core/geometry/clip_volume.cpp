#include "core/geometry/clip_volume.hpp"

#include <glm/matrix.hpp>

#include <algorithm>

namespace hs {

template <>
std::span<const Named<geometry::ClipPlane>> names<geometry::ClipPlane>() {
    using geometry::ClipPlane;
    static constexpr std::array<Named<ClipPlane>, 8> table{{
        {ClipPlane::near, "near", "in front of the near plane"},
        {ClipPlane::far, "far", "nearer than the far plane"},
        {ClipPlane::left, "left", "right of the left plane, x >= -w"},
        {ClipPlane::right, "right", "left of the right plane, x <= w"},
        {ClipPlane::bottom, "bottom", "above the bottom plane, y >= -w"},
        {ClipPlane::top, "top", "below the top plane, y <= w"},
        {ClipPlane::user0, "user 0", "inside the first user plane"},
        {ClipPlane::user1, "user 1", "inside the second user plane"},
    }};
    return table;
}

} // namespace hs

namespace hs::geometry {

ClipVolume clip_volume(const scene::Settings& settings, const glm::mat4& projection) {
    using math::HalfSpace;
    const HalfSpace z_from_minus_w{0.0F, 0.0F, 1.0F, 1.0F};
    const HalfSpace z_from_zero{0.0F, 0.0F, 1.0F, 0.0F};
    const HalfSpace z_to_w{0.0F, 0.0F, -1.0F, 1.0F};

    // Choose which end of z is near: reversed depth stores 1 there
    ClipVolume volume;
    switch (settings.depth_convention) {
    case scene::DepthConvention::opengl: volume.planes = {z_from_minus_w, z_to_w}; break;
    case scene::DepthConvention::direct3d: volume.planes = {z_from_zero, z_to_w}; break;
    case scene::DepthConvention::reversed: volume.planes = {z_to_w, z_from_zero}; break;
    }

    // The sides; with a guard band farther out, so that few triangles need to be cut there
    const float g = settings.guard_band;
    volume.planes[2] = {1.0F, 0.0F, 0.0F, g};
    volume.planes[3] = {-1.0F, 0.0F, 0.0F, g};
    volume.planes[4] = {0.0F, 1.0F, 0.0F, g};
    volume.planes[5] = {0.0F, -1.0F, 0.0F, g};

    // Carry user planes to clip space: a plane row vector h with h·p_eye = h·P⁻¹·p_clip
    const std::size_t user_planes = std::min<std::size_t>(settings.clip_planes.size(), 2);
    for (std::size_t k = 0; k < user_planes; ++k) {
        const glm::vec4 row = settings.clip_planes[k] * glm::inverse(projection);
        volume.planes[6 + k] = {row.x, row.y, row.z, row.w};
    }
    volume.count = 6 + static_cast<int>(user_planes);
    return volume;
}

} // namespace hs::geometry
