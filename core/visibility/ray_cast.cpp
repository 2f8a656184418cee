#include "core/visibility/ray_cast.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace hs::visibility {

Ray ray_through(
    const glm::dvec2& window,
    const glm::dvec2& window_size,
    const glm::dmat4& clip_to_world,
    const NdcDepths& depths
) {
    const double x = 2.0 * window.x / window_size.x - 1.0;
    const double y = 1.0 - 2.0 * window.y / window_size.y;
    const auto world = [&](double depth) {
        const glm::dvec4 p = clip_to_world * glm::dvec4{x, y, depth, 1.0};
        return glm::dvec3{p} / p.w;
    };
    const glm::dvec3 origin = world(depths.near);
    return {origin, world(depths.far) - origin};
}

glm::dvec3 ray_volumes(const Ray& ray, const RayTriangle& triangle) {
    const glm::dvec3 a = triangle[0] - ray.origin;
    const glm::dvec3 b = triangle[1] - ray.origin;
    const glm::dvec3 c = triangle[2] - ray.origin;
    return {
        glm::dot(ray.direction, glm::cross(b, c)),
        glm::dot(ray.direction, glm::cross(c, a)),
        glm::dot(ray.direction, glm::cross(a, b))};
}

RayMeeting meet(const Ray& ray, const RayTriangle& triangle) {
    const glm::dvec3 volumes = ray_volumes(ray, triangle);
    const double all = volumes.x + volumes.y + volumes.z;
    if (all == 0.0) {
        return {};
    }
    const bool inside = (volumes.x >= 0.0 && volumes.y >= 0.0 && volumes.z >= 0.0) ||
                        (volumes.x <= 0.0 && volumes.y <= 0.0 && volumes.z <= 0.0);
    const glm::dvec3 weights = volumes / all;
    const glm::dvec3 at = weights.x * (triangle[0] - ray.origin) +
                          weights.y * (triangle[1] - ray.origin) +
                          weights.z * (triangle[2] - ray.origin);
    return {
        .hit = inside,
        .t = glm::dot(at, ray.direction) / glm::dot(ray.direction, ray.direction),
        .weights = weights};
}

} // namespace hs::visibility
