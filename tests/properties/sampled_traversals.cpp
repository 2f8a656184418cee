// All traversals find the same samples of the same pixels, whether they ask them, know a tile by
// its corners, or send a scanline through them.
#include "core/pipeline/draw_frame.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"
#include "tests/support/rasterized.hpp"
#include "tests/support/triangle_soup.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <vector>

using namespace hs;

namespace {

constexpr std::array sample_counts{2, 4, 8};

using Emission = std::tuple<PixelPos, raster::EdgeValues, raster::CoverageMask>;
using Emissions = std::vector<Emission>;

std::vector<scene::TraversalKind> sampled_traversals() {
    std::vector<scene::TraversalKind> kinds;
    for (const Named<scene::TraversalKind>& kind : names<scene::TraversalKind>()) {
        if (kind.value != scene::TraversalKind::homogeneous) {
            kinds.push_back(kind.value);
        }
    }
    return kinds;
}

/// What a traversal tells and spends. A part that resumes listens from its first unit on.
struct Story : raster::SilentTraversal {
    raster::Cost cost_sum;
    int steps = 0;
    bool listening = true;

    void unit(int) { listening = true; }
    void cost(const raster::Cost& cost) { cost_sum += listening ? cost : raster::Cost{}; }
    void sample_tested(const raster::SampleTest&) { ++steps; }
    void tile_tested(const raster::TileTest&) { ++steps; }
    void edges_bucketed(const raster::EdgeTable&) { steps += listening ? 1 : 0; }
    void edges_activated(const raster::ActiveEdges&) { ++steps; }
    void span_found(const raster::Span&) { ++steps; }
};

Emissions emissions(
    const raster::TraversalChoice& choice,
    const raster::SampledSetup& setup,
    const PixelRect& image,
    Story& story,
    const raster::UnitRange& units = {}
) {
    Emissions found;
    story.listening = units.first == 0;
    raster::traverse(
        choice,
        setup,
        image,
        units,
        story,
        [&](PixelPos pixel, const raster::EdgeValues& center, raster::CoverageMask covered) {
            found.emplace_back(pixel, center, covered);
        }
    );
    std::ranges::sort(found);
    return found;
}

/// By the definition: every sample of every pixel of the image, asked one at a time.
Emissions by_definition(const raster::SampledSetup& setup, const PixelRect& image) {
    Emissions found;
    for (int x = image.x0; x < image.x1; ++x) {
        for (int y = image.y0; y < image.y1; ++y) {
            const raster::EdgeValues center = setup.evaluate({x, y});
            const auto covered = raster::covered_samples(setup, setup.samples, center);
            if (covered != 0) {
                found.emplace_back(PixelPos{x, y}, center, covered);
            }
        }
    }
    return found;
}

/// Calls `check(setup, image)` for so many triangles of every kind, with every pattern.
template <typename Check>
void for_many_setups(int count, Check&& check) {
    tests::Random random(73);
    for (int i = 0; i < count; ++i) {
        const PixelRect image{
            0, 0, 1 + static_cast<int>(random.below(40)), 1 + static_cast<int>(random.below(40))};
        const auto kind =
            static_cast<tests::SoupKind>(static_cast<unsigned>(i) % tests::soup_kinds);
        std::vector<glm::vec4> corners;
        for (const glm::dvec2& window : tests::soup_triangle(kind, image, random)) {
            corners.push_back(tests::clip_at(window, 0.0F, 1.0F, image));
        }
        const auto viewport = geometry::make_viewport(image, scene::DepthConvention::opengl);
        auto setup = tests::setup_of(tests::placed(corners, viewport), image);
        for (const int samples : sample_counts) {
            if (setup) {
                setup->bounds = raster::bounds_of_samples(*setup, samples, image);
                check(raster::at_samples(*setup, samples), image);
            }
        }
    }
}

} // namespace

TEST_CASE("every traversal finds every covered sample exactly once", "[property][raster]") {
    std::map<std::string_view, int> wrong;
    std::size_t found = 0;
    for_many_setups(3000, [&](const raster::SampledSetup& setup, const PixelRect& image) {
        const Emissions expected = by_definition(setup, image);
        found += expected.size();
        for (const scene::TraversalKind kind : sampled_traversals()) {
            Story story;
            wrong[name_of(kind)] += emissions({kind}, setup, image, story) == expected ? 0 : 1;
        }
    });
    CHECK(found > 100'000);
    for (const auto& [name, count] : wrong) {
        INFO(name);
        CHECK(count == 0);
    }
}

TEST_CASE("tiles of every size find the same samples", "[property][raster]") {
    std::map<int, int> wrong;
    for_many_setups(1000, [&](const raster::SampledSetup& setup, const PixelRect& image) {
        const Emissions expected = by_definition(setup, image);
        for (int size = 2; size <= 64; size *= 2) {
            Story story;
            const raster::TraversalChoice choice{scene::TraversalKind::hierarchical, size};
            wrong[size] += emissions(choice, setup, image, story) == expected ? 0 : 1;
        }
    });
    for (const auto& [size, count] : wrong) {
        INFO("tiles of " << size << " pixels");
        CHECK(count == 0);
    }
}

TEST_CASE("samples in parts are found, told and paid for as in one go", "[property][raster]") {
    std::map<std::string_view, int> wrong;
    for_many_setups(600, [&](const raster::SampledSetup& setup, const PixelRect& image) {
        for (const scene::TraversalKind kind : sampled_traversals()) {
            Story whole;
            const Emissions expected = emissions({kind}, setup, image, whole);
            Emissions found;
            raster::Cost cost;
            int steps = 0;
            for (const raster::UnitRange& range :
                 {raster::UnitRange{0, 3}, raster::UnitRange{3, 4}, raster::UnitRange{4}}) {
                Story part;
                const Emissions some = emissions({kind}, setup, image, part, range);
                found.insert(found.end(), some.begin(), some.end());
                cost += part.cost_sum;
                steps += part.steps;
            }
            std::ranges::sort(found);
            const bool same = found == expected && cost == whole.cost_sum && steps == whole.steps;
            wrong[name_of(kind)] += same ? 0 : 1;
        }
    });
    for (const auto& [name, count] : wrong) {
        INFO(name);
        CHECK(count == 0);
    }
}

TEST_CASE("every unit of a traversal of samples has a step", "[property][raster]") {
    struct Units : Story {
        int before = -1; ///< steps told when the current unit began
        int empty = 0;
        void unit(int) {
            close();
            before = steps;
        }
        void close() { empty += before == steps ? 1 : 0; }
    };
    std::map<std::string_view, int> wrong;
    for_many_setups(600, [&](const raster::SampledSetup& setup, const PixelRect& image) {
        for (const scene::TraversalKind kind : sampled_traversals()) {
            if (setup.bounds.empty()) {
                continue;
            }
            Units units;
            const auto ignore = [](PixelPos, const raster::EdgeValues&, raster::CoverageMask) {};
            raster::traverse({kind}, setup, image, {}, units, ignore);
            units.close();
            wrong[name_of(kind)] += units.empty;
        }
    });
    for (const auto& [name, count] : wrong) {
        INFO(name);
        CHECK(count == 0);
    }
}

TEST_CASE("traversals of samples agree on the largest triangles", "[property][raster]") {
    constexpr std::int32_t far = (1 << 30) - 1; // 2^22 pixels, the limit of snapping
    const PixelRect image{0, 0, 64, 64};
    const std::array<FixedPosition, 3> v{{{-far, -far}, {far, -far}, {0, far}}};
    for (const int samples : sample_counts) {
        raster::TriangleSetup setup =
            raster::set_up(v, geometry::doubled_area(v[0], v[1], v[2]), image);
        setup.bounds = raster::bounds_of_samples(setup, samples, image);
        const raster::SampledSetup sampled = raster::at_samples(setup, samples);
        for (const scene::TraversalKind kind : sampled_traversals()) {
            INFO(name_of(kind));
            Story story;
            CHECK(emissions({kind}, sampled, image, story) == by_definition(sampled, image));
        }
    }
}

namespace {

/// Hears nothing, and is drawn for by the traversal that was chosen all the same.
struct Chosen : pipeline::NullTrace {
    static constexpr bool ignores_traversal = false;
};

} // namespace

TEST_CASE("what samples hold does not depend on the traversal", "[property][raster]") {
    int sampled = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const auto scene = tests::sampled_scene(seed);
        if (scene->settings.samples == 1) {
            continue;
        }
        ++sampled;
        std::uint64_t first = 0;
        for (const scene::TraversalKind kind : sampled_traversals()) {
            auto variant = std::make_shared<scene::Scene>(*scene);
            variant->settings.traversal = kind;
            variant->settings.color_format = scene::ColorFormat::rgba32f;
            pipeline::Frame frame(variant);
            framebuffer::Framebuffer target(variant->settings);
            Chosen nothing;
            pipeline::draw_frame(frame, target, nothing);
            first = kind == sampled_traversals().front() ? target.digest() : first;
            INFO(scene->name << ", " << name_of(kind));
            REQUIRE(target.digest() == first);
        }
    }
    CHECK(sampled > 50);
}
