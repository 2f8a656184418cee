#include "core/geometry/eye_facing.hpp"

#include "tests/support/catch.hpp"

#include <vector>

using namespace hs;

namespace {

geometry::EyeFacing facing_of(
    const std::vector<math::EyePosition>& polygon,
    bool orthographic = false,
    scene::Winding front_face = scene::Winding::ccw
) {
    return geometry::eye_facing(polygon, front_face, orthographic, -1.0F);
}

const std::vector<math::EyePosition> square{
    {-1, -1, -4, 1}, {1, -1, -4, 1}, {1, 1, -4, 1}, {-1, 1, -4, 1}};

} // namespace

TEST_CASE("Newell's normal is twice the area long and faces who sees ccw", "[geometry][facing]") {
    const geometry::EyeFacing facing = facing_of(square);
    CHECK(facing.normal == glm::vec3{0.0F, 0.0F, 8.0F});
    CHECK(facing.center == glm::vec3{0.0F, 0.0F, -4.0F});
    CHECK(facing.view == facing.center);
    CHECK(facing.dot == -32.0F);
}

TEST_CASE("front_face = cw turns the normal around", "[geometry][facing]") {
    CHECK(facing_of(square, false, scene::Winding::cw).dot == 32.0F);
}

TEST_CASE("an orthographic line of sight is the same everywhere", "[geometry][facing]") {
    // Its plane passes between the eye and straight ahead: perspective sees the back
    const std::vector<math::EyePosition> slanted{{-9, -1, -5, 1}, {-8, -1, -3, 1}, {-9, 1, -5, 1}};
    CHECK(facing_of(slanted, true).dot < 0.0F);
    CHECK(facing_of(slanted, false).dot > 0.0F);
    CHECK(facing_of(slanted, true).view == glm::vec3{0.0F, 0.0F, -1.0F});
}

TEST_CASE("a reflex corner first does not turn Newell's normal", "[geometry][facing]") {
    // An arrow head whose first corner is reflex: the cross product there points backwards
    const std::vector<math::EyePosition> arrow{
        {0, 0, -3, 1}, {1, -1, -3, 1}, {0, 2, -3, 1}, {-1, -1, -3, 1}};
    CHECK(facing_of(arrow).normal.z > 0.0F);
}

TEST_CASE("a polygon seen edge-on has V · N = 0", "[geometry][facing]") {
    CHECK(facing_of({{0, 0, -1, 1}, {0, 0, -3, 1}, {0, 2, -3, 1}}).dot == 0.0F);
}
