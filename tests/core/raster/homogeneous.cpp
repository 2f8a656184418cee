#include "core/raster/homogeneous.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/exact_triangle.hpp"
#include "tests/support/made_scene.hpp"
#include "tests/support/random_scene.hpp"
#include "tests/support/soup_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>

using namespace hs;

namespace {

const glm::vec4 a{-0.5F, -0.5F, 0.0F, 1.0F};
const glm::vec4 b{0.75F, -0.5F, 0.0F, 1.0F};
const glm::vec4 c{0.0F, 0.5F, 0.0F, 1.0F};

std::shared_ptr<scene::Scene> unclipped(const std::vector<glm::vec4>& corners) {
    auto scene = tests::clip_space_scene(corners, 40, 30);
    scene->settings.traversal = scene::TraversalKind::homogeneous;
    scene->settings.clip_enabled = false;
    return scene;
}

std::int64_t fragments(const std::shared_ptr<scene::Scene>& scene) {
    const tests::Drawing drawing = tests::drawn(scene);
    std::int64_t sum = 0;
    for (const int count : drawing.covered) {
        sum += count;
    }
    return sum;
}

} // namespace

TEST_CASE("a triangle wholly behind the eye draws nothing", "[raster][homogeneous]") {
    CHECK(fragments(unclipped({a, b, c})) > 100);
    // (−a) × (−b) = a × b: the planes are the same, the determinant is not
    CHECK(fragments(unclipped({-a, -b, -c})) == 0);
}

TEST_CASE("scaling a vertex by a positive number changes nothing", "[raster][homogeneous]") {
    const tests::Drawing drawing = tests::drawn(unclipped({a, b, c}));
    const tests::Drawing scaled = tests::drawn(unclipped({2.0F * a, 0.5F * b, 8.0F * c}));
    CHECK(drawing.covered == scaled.covered);
}

TEST_CASE("a triangle seen edge-on draws nothing", "[raster][homogeneous]") {
    CHECK(fragments(unclipped({a, b, a + b})) == 0);
    CHECK(fragments(unclipped({a, -a, c})) == 0);
    CHECK(fragments(unclipped({a, b, glm::vec4{0.0F}})) == 0);
}

TEST_CASE("facing across the eye is the clipped polygon's", "[raster][homogeneous]") {
    tests::Random random(81);
    int compared = 0;
    for (int i = 0; i < 300; ++i) {
        std::vector<glm::vec4> corners;
        corners.reserve(3);
        for (int k = 0; k < 3; ++k) {
            corners.emplace_back(
                random.between(-2.0F, 2.0F),
                random.between(-2.0F, 2.0F),
                random.between(-0.5F, 0.5F),
                random.between(-1.0F, 3.0F)
            );
        }
        auto scene = tests::clip_space_scene(corners, 40, 30);
        scene->settings.cull = scene::CullFace::back;
        const std::int64_t clipped = fragments(scene);
        scene->settings.traversal = scene::TraversalKind::homogeneous;
        const std::int64_t whole = fragments(scene);
        compared += clipped > 20 ? 1 : 0;
        INFO("triangle " << i << ": " << clipped << " fragments clipped, " << whole << " whole");
        CHECK(std::abs(clipped - whole) <= 4); // centers within 1/256 pixel of an edge
    }
    CHECK(compared > 50);
}

TEST_CASE(
    "depth and colors across the eye are those of exact interpolation", "[raster][homogeneous]"
) {
    tests::Random random(82);
    std::int64_t wrong = 0;
    std::int64_t compared = 0;
    for (int i = 0; i < 300; ++i) {
        tests::Soup soup;
        std::vector<glm::vec4> corners;
        for (int k = 0; k < 3; ++k) {
            const glm::vec4 corner{
                random.between(-2.0F, 2.0F),
                random.between(-2.0F, 2.0F),
                random.between(-0.5F, 0.5F),
                k == 0 ? -0.5F : random.between(0.5F, 3.0F)};
            corners.push_back(corner);
            soup.push_back({corner, {k == 0, k == 1, k == 2, 1}});
        }
        scene::Settings settings;
        settings.width = 40;
        settings.height = 30;
        settings.traversal = scene::TraversalKind::homogeneous;
        settings.color_format = scene::ColorFormat::rgba32f;
        const tests::Drawing drawing = tests::drawn(tests::soup_scene(soup, settings));
        const tests::ExactTriangle exact(corners, settings.image());
        for (std::size_t k = 0; k < drawing.covered.size(); ++k) {
            const PixelPos pixel = drawing.pixel(k);
            const glm::dvec2 p = tests::center(pixel);
            if (drawing.covered[k] == 0) {
                continue;
            }
            ++compared;
            const glm::vec4 color = drawing.target.color(pixel);
            const glm::dvec3 weights = exact.perspective_weights(p);
            for (int channel = 0; channel < 3; ++channel) {
                const auto ours = static_cast<double>(color[channel]);
                wrong += std::fabs(ours - weights[channel]) < 1.0e-5 ? 0 : 1;
            }
            const auto depth = static_cast<double>(drawing.target.depth(pixel));
            wrong += std::fabs(depth - exact.depth(p)) < 1.0e-5 ? 0 : 1;
        }
    }
    CHECK(compared > 5000);
    CHECK(wrong == 0);
}
