#include "core/geometry/eye_facing.hpp"

#include <glm/geometric.hpp>

namespace hs::geometry {

EyeFacing eye_facing(
    std::span<const math::EyePosition> polygon,
    scene::Winding front_face,
    bool orthographic,
    float forward
) {
    EyeFacing facing;

    // Newell's sum: the areas of the polygon's shadows on the three coordinate planes
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const math::EyePosition& p = polygon[i];
        const math::EyePosition& q = polygon[(i + 1) % polygon.size()];
        facing.normal.x += (p.y - q.y) * (p.z + q.z);
        facing.normal.y += (p.z - q.z) * (p.x + q.x);
        facing.normal.z += (p.x - q.x) * (p.y + q.y);
        facing.center += glm::vec3{p.x, p.y, p.z};
    }
    facing.center /= static_cast<float>(polygon.size());

    // Looking along +z is a left-handed eye space: counterclockwise turns the normal away
    const bool turned = (front_face == scene::Winding::cw) != (forward > 0.0F);
    if (turned) {
        facing.normal = -facing.normal;
    }
    facing.view = orthographic ? glm::vec3{0.0F, 0.0F, forward} : facing.center;
    facing.dot = glm::dot(facing.view, facing.normal);
    return facing;
}

} // namespace hs::geometry
