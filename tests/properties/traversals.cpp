// All traversals ask different pixels in a different order, and find the same fragments.
#include "core/pipeline/draw_frame.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/rasterized.hpp"
#include "tests/support/triangle_soup.hpp"

#include <algorithm>
#include <array>
#include <map>

using namespace hs;

namespace {

/// Every emission, by pixel, in one comparable order.
using Emissions = std::vector<std::pair<PixelPos, raster::EdgeValues>>;

Emissions emissions(
    const raster::TraversalChoice& choice,
    const raster::TriangleSetup& setup,
    const PixelRect& image,
    const raster::UnitRange& units = {}
) {
    Emissions found;
    raster::SilentTraversal silent;
    raster::traverse(
        choice,
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
            wrong[kind.name] += emissions({kind.value}, setup, image) == expected ? 0 : 1;
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
                const Emissions part = emissions({kind.value}, setup, image, range);
                parts.insert(parts.end(), part.begin(), part.end());
            }
            std::ranges::sort(parts);
            wrong[kind.name] += parts == emissions({kind.value}, setup, image) ? 0 : 1;
        }
    });
    for (const auto& [name, count] : wrong) {
        INFO(name);
        CHECK(count == 0);
    }
}

TEST_CASE("tiles of every size find the same fragments", "[property][raster]") {
    std::map<int, int> wrong;
    for_many_setups(1000, [&](const raster::TriangleSetup& setup, const PixelRect& image) {
        const Emissions expected = by_definition(setup, image);
        for (int size = 2; size <= 64; size *= 2) {
            const raster::TraversalChoice choice{scene::TraversalKind::hierarchical, size};
            wrong[size] += emissions(choice, setup, image) == expected ? 0 : 1;
        }
    });
    for (const auto& [size, count] : wrong) {
        INFO("tiles of " << size << " pixels");
        CHECK(count == 0);
    }
}

namespace {

/// Adds up what a traversal spends, and in which kinds of steps. A part that resumes listens from
/// its first unit on.
struct Expenses : raster::SilentTraversal {
    raster::Cost total;
    int steps = 0;
    bool listening = true;

    void unit(int) { listening = true; }
    void cost(const raster::Cost& cost) { total += listening ? cost : raster::Cost{}; }
    void edge_test(PixelPos, const raster::EdgeValues&, bool) { ++steps; }
    void tile_tested(const raster::TileTest&) { ++steps; }
    void edges_activated(const raster::ActiveEdges&) { ++steps; }
    void span_found(const raster::Span&) { ++steps; }
    void planes_tested(PixelPos, const raster::PlaneTest&) { ++steps; }
};

Expenses expenses(
    scene::TraversalKind kind,
    const raster::TriangleSetup& setup,
    const PixelRect& image,
    const raster::UnitRange& units = {}
) {
    Expenses sum;
    sum.listening = units.first == 0;
    raster::traverse({kind}, setup, image, units, sum, [](PixelPos, const raster::EdgeValues&) {});
    return sum;
}

} // namespace

TEST_CASE(
    "a traversal run in parts tells and spends what it does in one go", "[property][raster]"
) {
    std::map<std::string_view, int> wrong;
    for_many_setups(1000, [&](const raster::TriangleSetup& setup, const PixelRect& image) {
        for (const Named<scene::TraversalKind>& kind : names<scene::TraversalKind>()) {
            raster::Cost parts;
            int steps = 0;
            for (const raster::UnitRange& range :
                 {raster::UnitRange{0, 3}, raster::UnitRange{3, 4}, raster::UnitRange{4}}) {
                const Expenses part = expenses(kind.value, setup, image, range);
                parts += part.total;
                steps += part.steps;
            }
            const Expenses whole = expenses(kind.value, setup, image);
            wrong[kind.name] += parts == whole.total && steps == whole.steps ? 0 : 1;
        }
    });
    for (const auto& [name, count] : wrong) {
        INFO(name);
        CHECK(count == 0);
    }
}

namespace {

/// Order-independent: how many pixels, and a sum that any other set of pixels is unlikely to have.
struct Fingerprint {
    std::uint64_t pixels = 0;
    std::uint64_t sum = 0;
    friend bool operator==(const Fingerprint&, const Fingerprint&) = default;
};

Fingerprint
fingerprint(scene::TraversalKind kind, const raster::TriangleSetup& setup, const PixelRect& image) {
    Fingerprint found;
    raster::SilentTraversal silent;
    raster::traverse(
        {kind},
        setup,
        image,
        {},
        silent,
        [&](PixelPos p, const raster::EdgeValues& e) {
            ++found.pixels;
            const auto pixel =
                static_cast<std::uint64_t>(p.y) << 32U | static_cast<std::uint64_t>(p.x);
            found.sum += (pixel + static_cast<std::uint64_t>(e[0]) * 31U) * 0x9E3779B97F4A7C15U;
        }
    );
    return found;
}

void check_all_agree(const std::array<FixedPosition, 3>& v, const PixelRect& image) {
    const std::int64_t area = geometry::doubled_area(v[0], v[1], v[2]);
    const raster::TriangleSetup setup = raster::set_up(v, area, image);
    const Fingerprint expected = fingerprint(scene::TraversalKind::bounding_box, setup, image);
    CHECK(expected.pixels > 0);
    for (const Named<scene::TraversalKind>& kind : names<scene::TraversalKind>()) {
        INFO(kind.name << ", " << image.width() << " pixels");
        CHECK(fingerprint(kind.value, setup, image) == expected);
    }
}

} // namespace

TEST_CASE("traversals agree on the smallest and on the largest image", "[property][raster]") {
    constexpr std::int32_t far = (1 << 30) - 1; // 2^22 pixels, the limit of snapping
    for (const int side : {1, 8192}) {
        const PixelRect image{0, 0, side, side};
        check_all_agree({{{-far, -far}, {far, -far}, {0, far}}}, image);
        const std::int32_t end = side * subpixel_scale;
        check_all_agree({{{-256, -300}, {end, end - 200}, {end - 600, end}}}, image); // a sliver
    }
}

namespace {

/// Whether no triangle of a scene needs clipping: those that are not wholly outside have w > 0 and
/// a place in the window everywhere and, where planes clip, cross none.
bool all_in_front(const std::shared_ptr<const scene::Scene>& scene) {
    pipeline::Frame frame(scene);
    pipeline::NullTrace nothing;
    for (pipeline::DrawCall& call : frame.calls()) {
        pipeline::run_vertex_stage(call, nothing);
        for (const scene::TriangleIndices& triangle : call.triangles()) {
            unsigned all = 0xFFU;
            unsigned any = 0;
            bool placed = true;
            for (int corner = 0; corner < 3; ++corner) {
                const pipeline::ShadedVertex& v = call.vertices[triangle[corner]];
                all &= v.outcode;
                any |= v.outcode;
                placed =
                    placed && v.clip.w > 0.0F && v.window.status == geometry::WindowStatus::placed;
            }
            const bool drawn = !call.settings.clip_enabled || all == 0;
            if (drawn && (!placed || (call.settings.clip_enabled && any != 0))) {
                return false;
            }
        }
    }
    return true;
}

} // namespace

namespace {

/// Hears nothing, and is drawn for by the traversal that was chosen all the same.
struct Chosen : pipeline::NullTrace {
    static constexpr bool ignores_traversal = false;
};

} // namespace

TEST_CASE("depth and varyings do not depend on the traversal", "[property][raster]") {
    int untouched = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const auto scene = tests::random_scene(seed);
        const bool whole = all_in_front(scene);
        untouched += whole ? 1 : 0;
        std::uint64_t first = 0;
        for (const Named<scene::TraversalKind>& kind : names<scene::TraversalKind>()) {
            if (kind.value == scene::TraversalKind::homogeneous && !whole) {
                continue; // what others clip and snap again, it leaves whole
            }
            auto variant = std::make_shared<scene::Scene>(*scene);
            variant->settings.traversal = kind.value;
            variant->settings.color_format = scene::ColorFormat::rgba32f;
            pipeline::Frame frame(variant);
            framebuffer::Framebuffer target(variant->settings);
            Chosen nothing;
            pipeline::draw_frame(frame, target, nothing);
            first = kind.value == scene::TraversalKind{} ? target.digest() : first;
            INFO(scene->name << ", " << kind.name);
            REQUIRE(target.digest() == first);
        }
    }
    CHECK(untouched > 10);
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
