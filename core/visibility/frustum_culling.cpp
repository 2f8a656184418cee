#include "core/visibility/frustum_culling.hpp"

#include <glm/common.hpp>

namespace hs::visibility {

BoxTest test_box(const Extents& box, const WorldPlane& plane) {
    const glm::dvec3 middle = 0.5 * (box.low + box.high);
    const glm::dvec3 half_sides = 0.5 * (box.high - box.low);
    const double distance = signed_distance(plane, middle);
    const double radius = glm::dot(glm::abs(plane.normal), half_sides);
    BoxTest test{
        .farthest_inside = distance + radius,
        .farthest_outside = distance - radius,
    };
    if (test.farthest_inside < -plane.tolerance) {
        test.verdict = BoxVerdict::outside;
    } else if (test.farthest_outside >= 0.0) {
        test.verdict = BoxVerdict::inside;
    }
    return test;
}

WorldPlane world_plane(
    const math::HalfSpace& clip_plane, const glm::mat4& world_to_clip, const glm::dvec3& reach
) {
    const glm::dvec4 coefficients{clip_plane.a, clip_plane.b, clip_plane.c, clip_plane.d};
    const glm::dmat4 matrix{world_to_clip};
    const glm::dvec4 row = coefficients * matrix;
    WorldPlane plane{.normal = glm::dvec3{row}, .offset = row.w};

    // In float a vertex goes through two matrices at most and then a plane: about a dozen roundings
    // of the absolute terms
    const glm::dmat4 absolute{
        glm::abs(matrix[0]), glm::abs(matrix[1]), glm::abs(matrix[2]), glm::abs(matrix[3])};
    const double terms = glm::dot(glm::abs(coefficients) * absolute, glm::dvec4{reach, 1.0});
    plane.tolerance = 4.0 * relative_tolerance * terms;
    return plane;
}

} // namespace hs::visibility
