// All traversals ask different pixels in a different order, and find the same fragments.
#include "core/pipeline/draw.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/rasterized.hpp"
#include "tests/support/triangle_soup.hpp"

#include <algorithm>
#include <map>

using namespace hs;

namespace {

/// Every emission, by pixel, in one comparable order.
using Emissions = std::vector<std::pair<PixelPos, raster::EdgeValues>>;

Emissions emissions(
    scene::TraversalKind kind,
    const raster::TriangleSetup& setup,
    const PixelRect& image,
    const raster::UnitRange& units = {}
) {
    Emissions found;
    raster::SilentTraversal silent;
    raster::traverse(
        {kind},
        setup,
        image,
        units,
        silent,
        [&](PixelPos pixel, const raster::EdgeValues& e) { found.emplace_back(pixel, e); }
    );
    std::ranges::sort(found);
    return found;
}

/// By the definition: every pixel of the image, asked one at a time.
Emissions by_definition(const raster::TriangleSetup& setup, const PixelRect& image) {
    Emissions found;
    for (int x = image.x0; x < image.x1; ++x) {
        for (int y = image.y0; y < image.y1; ++y) {
            const raster::EdgeValues e = setup.evaluate({x, y});
            if (setup.covers(e)) {
                found.emplace_back(PixelPos{x, y}, e);
            }
        }
    }
    return found;
}

/// Calls `check(setup, image)` for triangles of every kind.
template <typename Check>
void for_many_setups(int count, Check&& check) {
    tests::Random random(71);
    for (int i = 0; i < count; ++i) {
        const PixelRect image{
            0, 0, 1 + static_cast<int>(random.below(50)), 1 + static_cast<int>(random.below(50))};
        const auto kind = static_cast<tests::SoupKind>(random.below(tests::soup_kinds));
        std::vector<glm::vec4> corners;
        for (const glm::dvec2& window : tests::soup_triangle(kind, image, random)) {
            corners.push_back(tests::clip_at(window, 0.0F, 1.0F, image));
        }
        const auto viewport = geometry::make_viewport(image, scene::DepthConvention::opengl);
        if (const auto setup = tests::setup_of(tests::placed(corners, viewport), image)) {
            check(*setup, image);
        }
    }
}

} // namespace

TEST_CASE("every traversal emits every covered pixel exactly once", "[property][raster]") {
    std::map<std::string_view, int> wrong;
    for_many_setups(4000, [&](const raster::TriangleSetup& setup, const PixelRect& image) {
        const Emissions expected = by_definition(setup, image);
        for (const Named<scene::TraversalKind>& kind : names<scene::TraversalKind>()) {
            wrong[kind.name] += emissions(kind.value, setup, image) == expected ? 0 : 1;
        }
    });
    for (const auto& [name, count] : wrong) {
        INFO(name);
        CHECK(count == 0);
    }
}

TEST_CASE("a traversal run in parts emits what it emits in one go", "[property][raster]") {
    std::map<std::string_view, int> wrong;
    for_many_setups(1000, [&](const raster::TriangleSetup& setup, const PixelRect& image) {
        for (const Named<scene::TraversalKind>& kind : names<scene::TraversalKind>()) {
            Emissions parts;
            for (const raster::UnitRange& range : {
                     raster::UnitRange{0, 3},
                     raster::UnitRange{3, 4},
                     raster::UnitRange{4, 4},
                     raster::UnitRange{4, 20},
                     raster::UnitRange{20},
                 }) {
                const Emissions part = emissions(kind.value, setup, image, range);
                parts.insert(parts.end(), part.begin(), part.end());
            }
            std::ranges::sort(parts);
            wrong[kind.name] += parts == emissions(kind.value, setup, image) ? 0 : 1;
        }
    });
    for (const auto& [name, count] : wrong) {
        INFO(name);
        CHECK(count == 0);
    }
}

TEST_CASE("depth and varyings do not depend on the traversal", "[property][raster]") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const auto scene = tests::random_scene(seed);
        std::uint64_t first = 0;
        for (const Named<scene::TraversalKind>& kind : names<scene::TraversalKind>()) {
            auto variant = std::make_shared<scene::Scene>(*scene);
            variant->settings.traversal = kind.value;
            variant->settings.color_format = scene::ColorFormat::rgba32f;
            pipeline::Frame frame(variant);
            framebuffer::Framebuffer target(variant->settings);
            pipeline::NullTrace nothing;
            pipeline::draw_frame(frame, target, nothing);
            first = kind.value == scene::TraversalKind{} ? target.digest() : first;
            INFO(scene->name << ", " << kind.name);
            REQUIRE(target.digest() == first);
        }
    }
}

TEST_CASE("the bounds of a setup hold every covered pixel", "[property][raster]") {
    int outside = 0;
    for_many_setups(4000, [&](const raster::TriangleSetup& setup, const PixelRect& image) {
        for (const auto& [pixel, values] : by_definition(setup, image)) {
            outside += setup.bounds.contains(pixel) ? 0 : 1;
        }
    });
    CHECK(outside == 0);
}

TEST_CASE("the three edge functions sum to the doubled area at every pixel", "[property][raster]") {
    int wrong = 0;
    for_many_setups(1000, [&](const raster::TriangleSetup& setup, const PixelRect&) {
        for (const PixelPos pixel : {PixelPos{0, 0}, PixelPos{17, 5}, PixelPos{-300, 8000}}) {
            const raster::EdgeValues e = setup.evaluate(pixel);
            wrong += e[0] + e[1] + e[2] == setup.doubled_area ? 0 : 1;
        }
    });
    CHECK(wrong == 0);
}
