#include "core/explain/eye_planes.hpp"

#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

#include <glm/geometric.hpp>

#include <cmath>

using namespace hs;

namespace {

/// A random scene drawn homogeneously; half of them through a camera without an eye.
std::shared_ptr<const scene::Scene> a_scene(std::uint64_t seed) {
    auto scene = std::make_shared<scene::Scene>(*tests::random_scene(seed));
    scene->settings.traversal = scene::TraversalKind::homogeneous;
    scene->settings.visibility = scene::Visibility::z_buffer;
    return scene;
}

} // namespace

// The pipeline tests pixels in the window, with coefficients and rounding of its own; the side of a
// ray in space is what these stand for.
TEST_CASE("a pixel's ray runs on the side that its plane test says", "[explain][traversal]") {
    int asked = 0;
    int wrong = 0;
    int outside = 0;
    for (std::uint64_t seed = 0; seed < 120; ++seed) {
        const auto recording = trace::record(a_scene(seed)).value();
        trace::Player player(recording);
        const trace::StepId stride = recording->end_step / 40 + 1;
        for (trace::StepId id = 0; id < recording->end_step; id += stride) {
            player.seek(id);
            const trace::StepDetail& detail = player.detail();
            const auto planes = explain::planes_through_eye(*recording, detail, player.current());
            if (!planes || !planes->ray || !detail.traversal->planes) {
                continue;
            }
            const raster::PlaneTest& test = *detail.traversal->planes;
            for (unsigned k = 0; k < 3; ++k) {
                const explain::PlaneThroughEye& plane = planes->planes[k];
                CHECK(
                    std::fabs(glm::dot(plane.normal, plane.edge[0])) <
                    1e-4F * glm::length(plane.edge[0]) + 1e-6F
                );
                const float side = glm::dot(plane.normal, *planes->ray);
                if (std::fabs(side) < 0.02F) {
                    continue; // snapping moves an edge by a part of a pixel
                }
                ++asked;
                outside += side < 0.0F ? 1 : 0;
                wrong += (side > 0.0F) == (test.edges[k] > 0.0) ? 0 : 1;
            }
        }
    }
    CHECK(asked > 1000);
    CHECK(outside > 200);
    CHECK(wrong == 0);
}

TEST_CASE("without an eye there are no planes through it", "[explain][traversal]") {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const auto scene = a_scene(seed);
        if (scene->camera.projection.kind != scene::ProjectionKind::identity) {
            continue;
        }
        const auto recording = trace::record(scene).value();
        trace::Player player(recording);
        for (trace::StepId id = 0; id < recording->end_step; id += recording->end_step / 20 + 1) {
            player.seek(id);
            CHECK_FALSE(explain::planes_through_eye(*recording, player.detail(), player.current()));
        }
    }
}
