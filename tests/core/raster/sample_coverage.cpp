#include "core/raster/sample_coverage.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/rasterized.hpp"
#include "tests/support/triangle_soup.hpp"

#include <map>
#include <vector>

using namespace hs;
using namespace hs::raster;

namespace {

constexpr PixelRect image{0, 0, 24, 18};
constexpr std::array sample_counts{1, 2, 4, 8};

std::optional<TriangleSetup> random_setup(tests::Random& random) {
    const auto kind = static_cast<tests::SoupKind>(random.below(tests::soup_kinds));
    std::vector<glm::vec4> corners;
    for (const glm::dvec2& window : tests::soup_triangle(kind, image, random)) {
        corners.push_back(tests::clip_at(window, 0.0F, 1.0F, image));
    }
    const auto viewport = geometry::make_viewport(image, scene::DepthConvention::opengl);
    return tests::setup_of(tests::placed(corners, viewport), image);
}

/// The same triangle moved so that the sample of every pixel comes to lie on its center.
TriangleSetup moved(const TriangleSetup& setup, const SampleOffset& offset) {
    std::array<FixedPosition, 3> vertices = setup.vertices;
    for (FixedPosition& vertex : vertices) {
        vertex.x -= offset.x;
        vertex.y -= offset.y;
    }
    const std::int64_t area =
        std::int64_t{vertices[1].x - vertices[0].x} * (vertices[2].y - vertices[0].y) -
        std::int64_t{vertices[1].y - vertices[0].y} * (vertices[2].x - vertices[0].x);
    return set_up(vertices, -area, image);
}

std::map<PixelPos, CoverageMask> visited(const TriangleSetup& setup, int samples) {
    std::map<PixelPos, CoverageMask> masks;
    SilentTraversal silent;
    visit_samples(
        setup,
        sample_steps(setup, samples),
        bounds_of_samples(setup, samples, image),
        {},
        silent,
        [&](PixelPos pixel, const EdgeValues&, CoverageMask mask) { masks[pixel] = mask; }
    );
    return masks;
}

} // namespace

// A sample off the center is the center of a triangle moved the other way, so the rule for centers,
// which Mesa confirms, is the oracle of the rule for samples.
TEST_CASE("a sample is covered as the center of the moved triangle is", "[unit][raster]") {
    tests::Random random(11);
    for (int i = 0; i < 4000; ++i) {
        const auto setup = random_setup(random);
        if (!setup) {
            continue;
        }
        for (const int samples : sample_counts) {
            const auto masks = visited(*setup, samples);
            for (int s = 0; s < samples; ++s) {
                const TriangleSetup shifted =
                    moved(*setup, sample_pattern(samples)[static_cast<std::size_t>(s)]);
                for (int y = image.y0; y < image.y1; ++y) {
                    for (int x = image.x0; x < image.x1; ++x) {
                        const auto found = masks.find({x, y});
                        const bool covered = found != masks.end() && has_sample(found->second, s);
                        REQUIRE(covered == shifted.covers(shifted.evaluate({x, y})));
                    }
                }
            }
        }
    }
}

TEST_CASE("a traversal of samples tells the same in parts as in one go", "[unit][raster]") {
    struct Listener : SilentTraversal {
        std::vector<std::pair<PixelPos, int>> asked;
        std::uint64_t spent = 0;
        void sample_tested(const SampleTest& test) { asked.emplace_back(test.pixel, test.sample); }
        void cost(const Cost& cost) { spent += cost.additions() + cost.multiplications(); }
    };
    tests::Random random(12);
    for (int i = 0; i < 300; ++i) {
        const auto setup = random_setup(random);
        if (!setup) {
            continue;
        }
        const PixelRect region = bounds_of_samples(*setup, 4, image);
        Listener whole;
        Listener parts;
        const auto ignore = [](PixelPos, const EdgeValues&, CoverageMask) {};
        const SampleSteps steps = sample_steps(*setup, 4);
        visit_samples(*setup, steps, region, {}, whole, ignore);
        for (int unit = 0; unit < region.height(); ++unit) {
            visit_samples(*setup, steps, region, {unit, unit + 1}, parts, ignore);
        }
        REQUIRE(whole.asked == parts.asked);
        REQUIRE(whole.spent == parts.spent);
    }
}
