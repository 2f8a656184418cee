#include "core/geometry/facing.hpp"

#include "tests/support/catch.hpp"

#include <limits>

using namespace hs;
using geometry::TriangleVerdict;
using scene::CullFace;
using scene::Winding;

TEST_CASE("counterclockwise as seen, with y down, has positive area", "[geometry][facing]") {
    // Right, then up (y decreases): counterclockwise
    CHECK(geometry::doubled_area({0, 0}, {256, 0}, {0, -256}) == 65536);
    CHECK(geometry::doubled_area({0, 0}, {0, -256}, {256, 0}) == -65536);
    CHECK(geometry::doubled_area({0, 0}, {256, 256}, {512, 512}) == 0);
}

TEST_CASE("the largest triangle that snaps has an exact area", "[geometry][facing]") {
    constexpr std::int32_t far = (1 << 30) - 1;
    const std::int64_t side = 2 * std::int64_t{far};
    CHECK(geometry::doubled_area({-far, far}, {far, far}, {-far, -far}) == side * side);
}

TEST_CASE("culling removes the side it names, and zero area always", "[geometry][facing]") {
    const auto verdict = [](std::int64_t area, Winding front, CullFace cull) {
        return geometry::face_verdict(area, front, cull);
    };
    CHECK(verdict(1, Winding::ccw, CullFace::none) == TriangleVerdict::drawn);
    CHECK(verdict(-1, Winding::ccw, CullFace::none) == TriangleVerdict::drawn);
    CHECK(verdict(1, Winding::ccw, CullFace::back) == TriangleVerdict::drawn);
    CHECK(verdict(-1, Winding::ccw, CullFace::back) == TriangleVerdict::back_facing);
    CHECK(verdict(1, Winding::ccw, CullFace::front) == TriangleVerdict::front_facing);
    CHECK(verdict(-1, Winding::ccw, CullFace::front) == TriangleVerdict::drawn);
    CHECK(verdict(1, Winding::cw, CullFace::back) == TriangleVerdict::back_facing);
    CHECK(verdict(-1, Winding::cw, CullFace::front) == TriangleVerdict::front_facing);
    for (const Named<CullFace>& cull : names<CullFace>()) {
        CHECK(verdict(0, Winding::ccw, cull.value) == TriangleVerdict::degenerate);
    }
}
