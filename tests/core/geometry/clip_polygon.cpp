#include "core/geometry/clip_polygon.hpp"

#include "tests/support/catch.hpp"

#include <cmath>
#include <limits>
#include <vector>

using namespace hs;
using geometry::ClipPolygon;

namespace {

ClipPolygon polygon_of(const std::vector<glm::vec4>& positions) {
    ClipPolygon polygon;
    for (const glm::vec4& p : positions) {
        geometry::ClipVertex vertex;
        vertex.position = math::to_position<math::ClipSpace>(p);
        vertex.varyings.set(0, p);
        polygon.add(vertex);
    }
    return polygon;
}

glm::vec4 position(const ClipPolygon& polygon, int i) {
    return math::to_vec4(polygon[i].position);
}

constexpr math::HalfSpace right_of_the_middle{1.0F, 0.0F, 0.0F, 0.0F};

/// Which planes clipped, in order.
struct PlaneTrace {
    std::vector<geometry::ClipPlane> planes;
    void clipped(geometry::ClipPlane plane, const ClipPolygon&, const ClipPolygon&) {
        planes.push_back(plane);
    }
};

} // namespace

TEST_CASE("one vertex inside leaves a triangle", "[geometry][clip]") {
    const ClipPolygon kept = geometry::clip_against(
        polygon_of({{1, 0, 0, 1}, {-1, 1, 0, 1}, {-1, -1, 0, 1}}), right_of_the_middle
    );
    REQUIRE(kept.count == 3);
    CHECK(position(kept, 0) == glm::vec4{0.0F, -0.5F, 0.0F, 1.0F});
    CHECK(position(kept, 1) == glm::vec4{1.0F, 0.0F, 0.0F, 1.0F});
    CHECK(position(kept, 2) == glm::vec4{0.0F, 0.5F, 0.0F, 1.0F});
}

TEST_CASE("two vertices inside leave a quadrilateral in the same order", "[geometry][clip]") {
    const ClipPolygon kept = geometry::clip_against(
        polygon_of({{1, 1, 0, 1}, {-1, 0, 0, 1}, {1, -1, 0, 1}}), right_of_the_middle
    );
    REQUIRE(kept.count == 4);
    CHECK(position(kept, 0) == glm::vec4{1.0F, 1.0F, 0.0F, 1.0F});
    CHECK(position(kept, 1) == glm::vec4{0.0F, 0.5F, 0.0F, 1.0F});
    CHECK(position(kept, 2) == glm::vec4{0.0F, -0.5F, 0.0F, 1.0F});
    CHECK(position(kept, 3) == glm::vec4{1.0F, -1.0F, 0.0F, 1.0F});
}

TEST_CASE("a vertex on the plane is inside and makes no new one", "[geometry][clip]") {
    const ClipPolygon kept = geometry::clip_against(
        polygon_of({{0, 1, 0, 1}, {1, 0, 0, 1}, {0, -1, 0, 1}}), right_of_the_middle
    );
    CHECK(kept.count == 3);
}

TEST_CASE("nothing of a polygon outside a plane is kept", "[geometry][clip]") {
    const ClipPolygon kept = geometry::clip_against(
        polygon_of({{-1, 1, 0, 1}, {-2, 0, 0, 1}, {-1, -1, 0, 1}}), right_of_the_middle
    );
    CHECK(kept.count == 0);
}

TEST_CASE("t is the inside distance over the sum of distances", "[geometry][clip]") {
    const ClipPolygon ends = polygon_of({{3, 8, 0, 1}, {-1, 0, 4, 5}});
    const geometry::ClipVertex cut = geometry::intersect_edge(ends[0], 3.0F, ends[1], -1.0F);
    CHECK(math::to_vec4(cut.position) == glm::vec4{0.0F, 2.0F, 3.0F, 4.0F}); // t = 3/4
    CHECK(cut.varyings.color() == glm::vec4{0.0F, 2.0F, 3.0F, 4.0F});
}

TEST_CASE("only planes that some vertex is outside of clip, near first", "[geometry][clip]") {
    const geometry::ClipVolume volume = geometry::clip_volume({}, glm::mat4{1.0F});
    const ClipPolygon triangle = polygon_of({{0, 0, 0, 1}, {3, 0, 0, 1}, {0, 0, -3, 1}});
    unsigned crossed = 0;
    for (int i = 0; i < triangle.count; ++i) {
        crossed |= geometry::outcode(volume, triangle[i].position);
    }
    PlaneTrace trace;
    const ClipPolygon kept =
        geometry::clip_polygon(triangle, volume, static_cast<geometry::Outcode>(crossed), trace);
    CHECK(kept.count == 4);
    CHECK(trace.planes == std::vector{geometry::ClipPlane::near, geometry::ClipPlane::right});
}

TEST_CASE("a vertex that is not a number never makes an endless polygon", "[geometry][clip]") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const geometry::ClipVolume volume = geometry::clip_volume({}, glm::mat4{1.0F});
    PlaneTrace trace;
    const ClipPolygon kept = geometry::clip_polygon(
        polygon_of({{0, 0, 0, 1}, {0.5F, 0, 0, 1}, {0, nan, 0, 1}}), volume, 0xFF, trace
    );
    CHECK(kept.count <= 3 + volume.count);
}
