#include "core/geometry/viewport.hpp"

#include "tests/support/catch.hpp"

#include <limits>

using namespace hs;
using geometry::WindowStatus;

namespace {

const geometry::Viewport hundred =
    geometry::make_viewport({0, 0, 100, 60}, scene::DepthConvention::opengl);

} // namespace

TEST_CASE("NDC corners land on image corners, y up turned down", "[geometry][viewport]") {
    CHECK(
        geometry::to_window({-1, 1, -1, 1}, hundred).window ==
        math::WindowPosition{0.0F, 0.0F, 0.0F}
    );
    CHECK(
        geometry::to_window({1, -1, 1, 1}, hundred).window ==
        math::WindowPosition{100.0F, 60.0F, 1.0F}
    );
    CHECK(
        geometry::to_window({0, 0, 0, 1}, hundred).window ==
        math::WindowPosition{50.0F, 30.0F, 0.5F}
    );
}

TEST_CASE("clip coordinates are divided by w", "[geometry][viewport]") {
    const geometry::WindowVertex v = geometry::to_window({2, -1, 3, 4}, hundred);
    CHECK(v.status == WindowStatus::placed);
    CHECK(v.inv_w == 0.25F);
    CHECK(v.ndc == math::NdcPosition{0.5F, -0.25F, 0.75F});
    CHECK(v.window == math::WindowPosition{75.0F, 37.5F, 0.875F});
    CHECK(v.fixed == FixedPosition{19072, 9472}); // (75 − ½)·256 and (37.5 − ½)·256
}

TEST_CASE("a viewport rectangle moves and scales the picture", "[geometry][viewport]") {
    const auto part = geometry::make_viewport({10, 20, 50, 40}, scene::DepthConvention::opengl);
    CHECK(geometry::to_window({-1, 1, 0, 1}, part).window.x == 10.0F);
    CHECK(geometry::to_window({-1, 1, 0, 1}, part).window.y == 20.0F);
    CHECK(geometry::to_window({1, -1, 0, 1}, part).window.x == 50.0F);
    CHECK(geometry::to_window({1, -1, 0, 1}, part).window.y == 40.0F);
}

TEST_CASE("Direct3D and reversed depth are z_ndc itself", "[geometry][viewport]") {
    for (const auto convention :
         {scene::DepthConvention::direct3d, scene::DepthConvention::reversed}) {
        const auto viewport = geometry::make_viewport({0, 0, 8, 8}, convention);
        CHECK(geometry::to_window({0, 0, 0.25F, 1}, viewport).window.depth == 0.25F);
    }
}

TEST_CASE("without a finite 1/w a vertex has no place", "[geometry][viewport]") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float denormal = std::numeric_limits<float>::denorm_min();
    for (const float w : {0.0F, -0.0F, nan, denormal}) {
        INFO("w = " << w);
        CHECK(geometry::to_window({1, 1, 1, w}, hundred).status == WindowStatus::at_eye);
    }
}

TEST_CASE("a vertex beyond the snap limit is too far, never an overflow", "[geometry][viewport]") {
    const float inf = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float far : {1.0e6F, 1.0e30F, inf, -inf, nan}) {
        INFO("coordinate " << far);
        CHECK(geometry::to_window({far, 0, 0, 1}, hundred).status == WindowStatus::too_far);
        CHECK(geometry::to_window({0, far, 0, 1}, hundred).status == WindowStatus::too_far);
    }
    CHECK(geometry::to_window({0, 0, inf, 1}, hundred).status == WindowStatus::too_far);
    CHECK(geometry::to_window({80000, 0, 0, 1}, hundred).status == WindowStatus::placed);
}
