#include "core/visibility/octree_walk.hpp"

namespace hs::visibility {

namespace {

WorldPlane facing(const WorldPlane& plane, const glm::dvec4& eye) {
    return signed_distance(plane, eye) < 0.0 ? turned(plane) : plane;
}

} // namespace

int octant_of_eye(const OctreeCell& cell, const glm::dvec4& eye) {
    unsigned octant = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const bool upper = eye[axis] - cell.middle[axis] * eye.w >= 0.0;
        octant |= upper ? 1U << static_cast<unsigned>(axis) : 0U;
    }
    return static_cast<int>(octant);
}

std::array<int, octants> octants_from(int octant) {
    // Walls crossed on the way: none, one, two, all three
    std::array<int, octants> order{0b000, 0b001, 0b010, 0b100, 0b011, 0b101, 0b110, 0b111};
    for (int& walls : order) {
        walls = static_cast<int>(static_cast<unsigned>(walls) ^ static_cast<unsigned>(octant));
    }
    return order;
}

bool in_front(const Octree& tree, std::int32_t a, std::int32_t b, const glm::dvec4& eye) {
    const Side side_of_a = classify(facing(tree.set.plane(b), eye), tree.set.polygon(a));
    if (side_of_a == Side::front || side_of_a == Side::on) {
        return true;
    }
    const Side side_of_b = classify(facing(tree.set.plane(a), eye), tree.set.polygon(b));
    return side_of_b == Side::back || side_of_b == Side::on;
}

double center_distance(const Octree& tree, std::int32_t i, const glm::dvec4& eye) {
    const glm::dvec3 at = center(tree.set.polygon(i));
    return eye.w == 0.0 ? -glm::dot(at, glm::dvec3{eye})
                        : glm::length(at - glm::dvec3{eye} / eye.w);
}

} // namespace hs::visibility
