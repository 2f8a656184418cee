// Coverage of triangles that cross the planes of the view volume, w = 0 included, against exact
// homogeneous coverage in double precision and against Mesa.
//
// Clipping makes new vertices, which are rounded and snapped. So a pixel may differ, but only if
// its center lies within 1/256 pixel of an edge of the exact clipped polygon.
#include "core/pipeline/frame.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/exact_triangle.hpp"
#include "tests/support/soup_scene.hpp"
#include "tests/support/triangle_soup.hpp"
#ifdef HALFSPACE_HAS_PEER
#include "tests/support/mesa.hpp"
#endif

#include <array>
#include <cmath>
#include <functional>

using namespace hs;

namespace {

constexpr double honest_distance = 1.0 / 256.0; // pixels
constexpr int triangles = 3000;

using RandomCorner = std::function<glm::vec4(tests::Random&)>;

/// Anywhere around the eye, up to `reach` from the world's origin.
RandomCorner around_the_eye(float reach) {
    return [reach](tests::Random& random) {
        const auto coordinate = [&] { return random.between(-reach, reach); };
        return glm::vec4{coordinate(), coordinate(), coordinate(), 1.0F};
    };
}

glm::vec4 anywhere_in_clip_space(tests::Random& random) {
    const auto coordinate = [&] { return random.between(-2.5F, 2.5F); };
    return {coordinate(), coordinate(), coordinate(), random.between(-1.0F, 3.0F)};
}

std::shared_ptr<scene::Scene> one_triangle(const RandomCorner& corner, tests::Random& random) {
    const tests::Soup soup{{corner(random)}, {corner(random)}, {corner(random)}};
    scene::Settings settings;
    settings.width = 64;
    settings.height = 48;
    settings.visibility = scene::Visibility::none;
    return std::make_shared<scene::Scene>(*tests::soup_scene(soup, settings));
}

void see_in_perspective(scene::Scene& scene, float near, float far) {
    scene.camera.projection.kind = scene::ProjectionKind::perspective;
    scene.camera.projection.near = near;
    scene.camera.projection.far = far;
}

/// User planes as clipping sees them.
std::vector<glm::vec4> user_planes(const std::shared_ptr<const scene::Scene>& scene) {
    const pipeline::Frame frame(scene);
    const geometry::ClipVolume& volume = frame.calls().front().volume;
    std::vector<glm::vec4> planes;
    for (int k = 6; k < volume.count; ++k) {
        const math::HalfSpace& h = volume.planes[static_cast<unsigned>(k)];
        planes.emplace_back(h.a, h.b, h.c, h.d);
    }
    return planes;
}

struct Tally {
    std::int64_t covered = 0;
    std::int64_t twice = 0; ///< pixels that two pieces of one triangle cover
    std::int64_t differing = 0;
    std::int64_t wrong = 0; ///< differing, and not near an edge
};

void compare_with_exact(
    const tests::Drawing& drawing, const tests::ExactTriangle& exact, Tally& tally
) {
    for (std::size_t i = 0; i < drawing.covered.size(); ++i) {
        const glm::dvec2 p = tests::center(drawing.pixel(i));
        const bool covered = drawing.covered[i] > 0;
        tally.covered += covered ? 1 : 0;
        tally.twice += drawing.covered[i] > 1 ? 1 : 0;
        if (covered != exact.covers(p)) {
            ++tally.differing;
            tally.wrong += exact.edge_within(p, honest_distance) ? 0 : 1;
        }
    }
}

/// Draws many triangles, one to a frame; `prepare` chooses camera and planes.
template <typename Prepare>
Tally compare_many(const RandomCorner& corner, Prepare&& prepare) {
    Tally tally;
    tests::Random random(5);
    for (int i = 0; i < triangles; ++i) {
        const auto scene = one_triangle(corner, random);
        prepare(*scene, random);
        const tests::Drawing drawing = tests::drawn(scene);
        const tests::ExactTriangle exact(
            drawing.clip[0], scene->settings.image(), user_planes(scene)
        );
        compare_with_exact(drawing, exact, tally);
    }
    return tally;
}

void check(const Tally& tally) {
    INFO(tally.covered << " covered pixels, " << tally.differing << " differ");
    CHECK(tally.covered > 200'000);
    CHECK(tally.wrong == 0);
    CHECK(tally.twice == 0);
}

} // namespace

TEST_CASE("clipped triangles cover what exact homogeneous coverage says", "[oracle][clip]") {
    for (const float near : {1.0F, 0.1F, 0.001F}) {
        INFO("near plane at " << near);
        check(compare_many(around_the_eye(4.0F), [near](scene::Scene& scene, tests::Random&) {
            see_in_perspective(scene, near, 10.0F);
        }));
    }
    for (const float reach : {40.0F, 4.0e5F}) {
        INFO("a world of " << reach);
        check(compare_many(around_the_eye(reach), [](scene::Scene& scene, tests::Random&) {
            see_in_perspective(scene, 0.1F, 1.0e6F);
        }));
    }
}

TEST_CASE("any clip coordinates cover what exact homogeneous coverage says", "[oracle][clip]") {
    check(compare_many(anywhere_in_clip_space, [](scene::Scene&, tests::Random&) {}));
}

TEST_CASE("user planes cut where exact homogeneous coverage says", "[oracle][clip]") {
    check(compare_many(around_the_eye(4.0F), [](scene::Scene& scene, tests::Random& random) {
        see_in_perspective(scene, 0.1F, 10.0F);
        scene.settings.clip_planes = {
            {1.0F, 0.5F, 0.25F, random.between(-1.0F, 3.0F)},
            {-0.3F, 0.7F, 0.5F, random.between(0.0F, 3.0F)}};
    }));
}

TEST_CASE("homogeneous rasterization covers the same without clipping", "[oracle][clip]") {
    check(compare_many(around_the_eye(4.0F), [](scene::Scene& scene, tests::Random& random) {
        see_in_perspective(scene, 0.1F, 10.0F);
        scene.settings.traversal = scene::TraversalKind::homogeneous;
        if (random.one_in(2)) {
            scene.settings.clip_planes = {{1.0F, 0.5F, 0.25F, random.between(-1.0F, 3.0F)}};
        }
    }));
    check(compare_many(anywhere_in_clip_space, [](scene::Scene& scene, tests::Random&) {
        scene.settings.traversal = scene::TraversalKind::homogeneous;
    }));
}

TEST_CASE("exact coverage tells a picture without clipping from the right one", "[oracle][clip]") {
    const Tally tally = compare_many(around_the_eye(4.0F), [](scene::Scene& scene, tests::Random&) {
        see_in_perspective(scene, 0.1F, 10.0F);
        scene.settings.clip_enabled = false;
    });
    CHECK(tally.wrong > tally.covered / 10);
}

#ifdef HALFSPACE_HAS_PEER
TEST_CASE("clipped triangles cover what they cover in Mesa", "[oracle][clip]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    Tally tally;
    tests::Random random(6);
    for (int i = 0; i < 2 * triangles; ++i) {
        const bool perspective = i % 2 == 0;
        const auto scene =
            one_triangle(perspective ? around_the_eye(4.0F) : anywhere_in_clip_space, random);
        if (perspective) {
            see_in_perspective(*scene, 0.1F, 10.0F);
        }
        const tests::Drawing ours = tests::drawn(scene);
        const peer::Coverage theirs = mesa->coverage(
            ours.clip[0],
            {.width = scene->settings.width,
             .height = scene->settings.height,
             .wide_viewport = false}
        );
        const tests::ExactTriangle exact(ours.clip[0], scene->settings.image());
        for (std::size_t k = 0; k < ours.covered.size(); ++k) {
            tally.covered += ours.covered[k];
            if ((ours.covered[k] > 0) != (theirs.bits[k] != 0)) {
                ++tally.differing;
                const bool near = exact.edge_within(tests::center(ours.pixel(k)), honest_distance);
                tally.wrong += near ? 0 : 1;
            }
        }
    }
    check(tally);
    CHECK(tally.differing <= tally.covered / 100'000);
}
#endif
