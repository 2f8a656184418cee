#include "core/raster/triangle_setup.hpp"

#include "core/geometry/facing.hpp"
#include "tests/support/catch.hpp"

#include <vector>

using namespace hs;

namespace {

constexpr PixelRect image{0, 0, 8, 8};

raster::TriangleSetup
setup_of(const FixedPosition& a, const FixedPosition& b, const FixedPosition& c) {
    return raster::set_up({a, b, c}, geometry::doubled_area(a, b, c), image);
}

std::vector<PixelPos> covered(const raster::TriangleSetup& setup) {
    std::vector<PixelPos> pixels;
    for (int y = 0; y < image.y1; ++y) {
        for (int x = 0; x < image.x1; ++x) {
            if (setup.covers(setup.evaluate({x, y}))) {
                pixels.push_back({x, y});
            }
        }
    }
    return pixels;
}

/// A pixel center.
constexpr FixedPosition at(int x, int y) {
    return {x * subpixel_scale, y * subpixel_scale};
}

} // namespace

TEST_CASE("both windings cover the same pixels with positive edges", "[raster]") {
    const raster::TriangleSetup ccw = setup_of(at(1, 1), at(2, 6), at(6, 2));
    const raster::TriangleSetup cw = setup_of(at(1, 1), at(6, 2), at(2, 6));
    CHECK(ccw.doubled_area > 0);
    CHECK(cw.doubled_area == ccw.doubled_area);
    CHECK(covered(cw) == covered(ccw));
    CHECK(covered(cw).size() > 5);
}

TEST_CASE("a right triangle on pixel centers keeps its top and left edges", "[raster][top-left]") {
    // Left edge x = 1, top edge y = 1, and a slanted right edge that owns nothing
    const raster::TriangleSetup setup = setup_of(at(1, 1), at(1, 4), at(4, 1));
    CHECK(covered(setup) == std::vector<PixelPos>{{1, 1}, {2, 1}, {3, 1}, {1, 2}, {2, 2}, {1, 3}});
}

TEST_CASE("its mirror image loses bottom and right edges", "[raster][top-left]") {
    // Right edge x = 4, bottom edge y = 4, and a slanted left edge that owns its ties
    const raster::TriangleSetup setup = setup_of(at(4, 4), at(4, 1), at(1, 4));
    CHECK(covered(setup) == std::vector<PixelPos>{{3, 2}, {2, 3}, {3, 3}});
}

TEST_CASE("the bounds end at the last pixel center within the triangle", "[raster]") {
    CHECK(setup_of(at(1, 1), at(1, 4), at(4, 1)).bounds == PixelRect{1, 1, 5, 5});
    CHECK(setup_of({257, 257}, {257, 1023}, {1023, 257}).bounds == PixelRect{2, 2, 4, 4});
    CHECK(setup_of({-999, -999}, {-999, 5000}, {5000, -999}).bounds == image);
    CHECK(setup_of({10, 10}, {10, 200}, {200, 10}).bounds.empty());
}

TEST_CASE("at each vertex one weight is the whole area", "[raster]") {
    const raster::TriangleSetup setup = setup_of(at(1, 1), at(2, 6), at(6, 2));
    CHECK(setup.evaluate({1, 1}) == raster::EdgeValues{0, setup.doubled_area, 0});
    CHECK(setup.evaluate({2, 6}) == raster::EdgeValues{0, 0, setup.doubled_area});
    CHECK(setup.evaluate({6, 2}) == raster::EdgeValues{setup.doubled_area, 0, 0});
}
