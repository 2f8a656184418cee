#include "core/geometry/clip_volume.hpp"

#include "core/scene/camera.hpp"
#include "tests/support/catch.hpp"

#include <limits>

using namespace hs;
using geometry::ClipPlane;

namespace {

unsigned bit(ClipPlane plane) {
    return 1U << static_cast<unsigned>(plane);
}

unsigned outcode_in(scene::DepthConvention convention, const math::ClipPosition& p) {
    scene::Settings settings;
    settings.depth_convention = convention;
    return geometry::outcode(geometry::clip_volume(settings, glm::mat4{1.0F}), p);
}

constexpr scene::DepthConvention opengl = scene::DepthConvention::opengl;
constexpr scene::DepthConvention direct3d = scene::DepthConvention::direct3d;
constexpr scene::DepthConvention reversed = scene::DepthConvention::reversed;

} // namespace

TEST_CASE("each side of the view volume has its bit", "[geometry][clip]") {
    CHECK(outcode_in(opengl, {0, 0, 0, 1}) == 0);
    CHECK(outcode_in(opengl, {-2, 0, 0, 1}) == bit(ClipPlane::left));
    CHECK(outcode_in(opengl, {2, 0, 0, 1}) == bit(ClipPlane::right));
    CHECK(outcode_in(opengl, {0, -2, 0, 1}) == bit(ClipPlane::bottom));
    CHECK(outcode_in(opengl, {0, 2, 0, 1}) == bit(ClipPlane::top));
    CHECK(outcode_in(opengl, {0, 0, -2, 1}) == bit(ClipPlane::near));
    CHECK(outcode_in(opengl, {0, 0, 2, 1}) == bit(ClipPlane::far));
    CHECK(
        outcode_in(opengl, {2, 2, 2, 1}) ==
        (bit(ClipPlane::right) | bit(ClipPlane::top) | bit(ClipPlane::far))
    );
}

TEST_CASE("points on a side are inside", "[geometry][clip]") {
    for (const float x : {-1.0F, 1.0F}) {
        CHECK(outcode_in(opengl, {x, 0, 0, 1}) == 0);
        CHECK(outcode_in(opengl, {0, x, 0, 1}) == 0);
        CHECK(outcode_in(opengl, {0, 0, x, 1}) == 0);
    }
}

TEST_CASE("near and far are where the depth convention has them", "[geometry][clip]") {
    const math::ClipPosition negative{0, 0, -0.5F, 1};
    const math::ClipPosition beyond{0, 0, 1.5F, 1};
    CHECK(outcode_in(opengl, negative) == 0);
    CHECK(outcode_in(direct3d, negative) == bit(ClipPlane::near));
    CHECK(outcode_in(reversed, negative) == bit(ClipPlane::far));
    CHECK(outcode_in(opengl, beyond) == bit(ClipPlane::far));
    CHECK(outcode_in(direct3d, beyond) == bit(ClipPlane::far));
    CHECK(outcode_in(reversed, beyond) == bit(ClipPlane::near));
}

TEST_CASE("behind the eye is outside opposite sides at once", "[geometry][clip]") {
    const unsigned code = outcode_in(opengl, {0, 0, 0, -1});
    CHECK(code == 0b111111U);
}

TEST_CASE("a vertex that is not a number is outside everything", "[geometry][clip]") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK(outcode_in(opengl, {0, 0, 0, nan}) == 0b111111U);
}

TEST_CASE("user planes in eye space clip where they stand", "[geometry][clip]") {
    scene::Settings settings;
    settings.clip_planes = {{0, 1, 0, -0.5F}, {1, 0, 0, 2}}; // y >= 1/2 and x >= -2
    scene::Camera camera;
    const auto projection = scene::projection_transform(camera, 1.5F, opengl);
    const geometry::ClipVolume volume = geometry::clip_volume(settings, projection.matrix);
    REQUIRE(volume.count == 8);
    const auto user_bits = [&](const math::EyePosition& p) {
        return geometry::outcode(volume, projection(p)) & 0b11000000U;
    };
    CHECK(user_bits({0, 0.6F, -5, 1}) == 0);
    CHECK(user_bits({0, 0.4F, -5, 1}) == bit(ClipPlane::user0));
    CHECK(user_bits({-2.1F, 0.6F, -5, 1}) == bit(ClipPlane::user1));
}

TEST_CASE("a guard band moves the sides and nothing else", "[geometry][clip]") {
    scene::Settings settings;
    settings.guard_band = 4.0F;
    const geometry::ClipVolume volume = geometry::clip_volume(settings, glm::mat4{1.0F});
    CHECK(geometry::outcode(volume, {3.9F, -4.0F, 0.0F, 1.0F}) == 0);
    CHECK(geometry::outcode(volume, {4.1F, 0.0F, 0.0F, 1.0F}) == 1U << 3U);
    CHECK(geometry::outcode(volume, {0.0F, -4.1F, 0.0F, 1.0F}) == 1U << 4U);
    CHECK(geometry::outcode(volume, {0.0F, 0.0F, 1.1F, 1.0F}) == 1U << 1U);
}
