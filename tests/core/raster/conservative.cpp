#include "core/raster/conservative.hpp"

#include "core/raster/sample_coverage.hpp"
#include "core/raster/traverse.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/rasterized.hpp"
#include "tests/support/triangle_soup.hpp"

#include <algorithm>
#include <set>
#include <vector>

using namespace hs;
using namespace hs::raster;

namespace {

constexpr PixelRect image{0, 0, 24, 18};

using Point = std::array<std::int64_t, 2>;
using Polygon = std::vector<Point>;

/// Whether two convex polygons, of either winding, share an area: no line along an edge of either
/// has them on its two sides. Written without the rasterizer's edge functions and bounding box: the
/// separating axis theorem (Gottschalk, Lin and Manocha, OBBTree, 1996), in integers.
bool share_an_area(const Polygon& a, const Polygon& b) {
    const auto separated_by_an_edge_of = [](const Polygon& p, const Polygon& q) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Point& from = p[i];
            const Point& to = p[(i + 1) % p.size()];
            const Point normal{to[1] - from[1], from[0] - to[0]};
            const auto along = [&](const Point& x) { return normal[0] * x[0] + normal[1] * x[1]; };
            const auto [p_low, p_high] = std::ranges::minmax(p, {}, along);
            const auto [q_low, q_high] = std::ranges::minmax(q, {}, along);
            if (along(p_high) <= along(q_low) || along(q_high) <= along(p_low)) {
                return true;
            }
        }
        return false;
    };
    return !separated_by_an_edge_of(a, b) && !separated_by_an_edge_of(b, a);
}

Polygon square_of(PixelPos pixel) {
    const std::int64_t x = std::int64_t{pixel.x} * subpixel_scale;
    const std::int64_t y = std::int64_t{pixel.y} * subpixel_scale;
    constexpr std::int64_t half = subpixel_scale / 2;
    return {{x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}};
}

std::vector<std::optional<TriangleSetup>> soup(std::uint64_t seed, int count) {
    tests::Random random(seed);
    const auto viewport = geometry::make_viewport(image, scene::DepthConvention::opengl);
    std::vector<std::optional<TriangleSetup>> setups;
    for (int i = 0; i < count; ++i) {
        const auto kind = static_cast<tests::SoupKind>(random.below(tests::soup_kinds));
        std::vector<glm::vec4> corners;
        for (const glm::dvec2& window : tests::soup_triangle(kind, image, random)) {
            corners.push_back(tests::clip_at(window, 0.0F, 1.0F, image));
        }
        setups.push_back(tests::setup_of(tests::placed(corners, viewport), image));
    }
    return setups;
}

std::set<PixelPos> covered_by(const TriangleSetup& setup, scene::TraversalKind kind) {
    std::set<PixelPos> pixels;
    tests::rasterize(setup, image, kind, [&](PixelPos pixel, const EdgeValues&) {
        pixels.insert(pixel);
    });
    return pixels;
}

constexpr std::array boxed{
    scene::TraversalKind::bounding_box,
    scene::TraversalKind::incremental,
    scene::TraversalKind::serpentine,
    scene::TraversalKind::hierarchical};

} // namespace

TEST_CASE(
    "conservative coverage is exactly the squares that share an area with the triangle",
    "[unit][raster]"
) {
    for (const auto& setup : soup(21, 3000)) {
        if (!setup) {
            continue;
        }
        TriangleSetup widened = *setup;
        widen_to_squares(widened, image);
        Polygon triangle;
        for (const FixedPosition& v : setup->vertices) {
            triangle.push_back({v.x, v.y});
        }
        std::set<PixelPos> expected;
        for (int y = image.y0; y < image.y1; ++y) {
            for (int x = image.x0; x < image.x1; ++x) {
                if (share_an_area(triangle, square_of({x, y}))) {
                    expected.insert({x, y});
                }
            }
        }
        for (const scene::TraversalKind kind : boxed) {
            INFO(name_of(kind));
            REQUIRE(covered_by(widened, kind) == expected);
        }
    }
}

TEST_CASE("conservative coverage contains every sample's coverage", "[unit][raster]") {
    for (const auto& setup : soup(22, 3000)) {
        if (!setup) {
            continue;
        }
        TriangleSetup widened = *setup;
        widen_to_squares(widened, image);
        const std::set<PixelPos> conservative =
            covered_by(widened, scene::TraversalKind::bounding_box);
        SilentTraversal silent;
        for (const int samples : {1, 2, 4, 8}) {
            visit_samples(
                *setup,
                sample_steps(*setup, samples),
                bounds_of_samples(*setup, samples, image),
                {},
                silent,
                [&](PixelPos pixel, const EdgeValues&, CoverageMask) {
                    REQUIRE(conservative.contains(pixel));
                }
            );
        }
    }
}
