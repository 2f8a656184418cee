#include "core/pipeline/draw_frame.hpp"
#include "core/trace/recording.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/soup_scene.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

using namespace hs;
using fragment::FragmentFate;
using geometry::TriangleVerdict;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// Verdicts of the triangles and fates of the fragments, in order.
struct Outcome : pipeline::NullTrace {
    std::vector<TriangleVerdict> verdicts;
    std::map<FragmentFate, int> fates;
    int shaded_fragments = 0;

    void shaded(const shading::ShadedFragment&) { ++shaded_fragments; }
    void fragment_end(FragmentFate fate) { ++fates[fate]; }
    void triangle_end(TriangleVerdict verdict, geometry::Outcode) { verdicts.push_back(verdict); }
};

scene::Settings settings_of(int width, int height) {
    scene::Settings settings;
    settings.width = width;
    settings.height = height;
    return settings;
}

Outcome
outcome(const tests::Soup& soup, const scene::Settings& settings, std::uint64_t* digest = nullptr) {
    pipeline::Frame frame(tests::soup_scene(soup, settings));
    framebuffer::Framebuffer target(settings);
    Outcome result;
    pipeline::draw_frame(frame, target, result);
    if (digest != nullptr) {
        *digest = target.digest();
    }
    return result;
}

TriangleVerdict verdict_on(
    const glm::vec4& a,
    const glm::vec4& b,
    const glm::vec4& c,
    const scene::Settings& settings = settings_of(16, 16)
) {
    return outcome({{a}, {b}, {c}}, settings).verdicts.front();
}

/// Two triangles that fill the image.
tests::Soup full_screen(float z, const glm::vec4& color) {
    return {
        {{-1, -1, z, 1}, color},
        {{1, -1, z, 1}, color},
        {{1, 1, z, 1}, color},
        {{-1, -1, z, 1}, color},
        {{1, 1, z, 1}, color},
        {{-1, 1, z, 1}, color}};
}

tests::Soup joined(tests::Soup first, const tests::Soup& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

const glm::vec4 white{1.0F};
const glm::vec4 red{1.0F, 0.0F, 0.0F, 1.0F};

} // namespace

TEST_CASE("every verdict is reached by a triangle that deserves it", "[pipeline]") {
    scene::Settings cull = settings_of(16, 16);
    scene::Settings unclipped = settings_of(16, 16);
    unclipped.clip_enabled = false;
    const glm::vec4 a{-0.5F, -0.5F, 0, 1};
    const glm::vec4 b{0.5F, -0.5F, 0, 1};
    const glm::vec4 c{0, 0.5F, 0, 1};
    CHECK(verdict_on(a, b, c) == TriangleVerdict::drawn);
    CHECK(verdict_on({2, 0, 0, 1}, {3, 0, 0, 1}, {2, 1, 0, 1}) == TriangleVerdict::outside);
    cull.cull = scene::CullFace::back;
    CHECK(verdict_on(c, b, a, cull) == TriangleVerdict::back_facing);
    cull.cull = scene::CullFace::front;
    CHECK(verdict_on(a, b, c, cull) == TriangleVerdict::front_facing);
    CHECK(verdict_on(a, b, a) == TriangleVerdict::degenerate);
    CHECK(
        verdict_on({0, 0, 0, 1}, {0.01F, 0, 0, 1}, {0, 0.01F, 0, 1}) ==
        TriangleVerdict::no_sample_covered
    );
    CHECK(verdict_on(a, b, {0, 0, 0, 0}, unclipped) == TriangleVerdict::behind_the_eye);
    CHECK(verdict_on(a, b, {1.0e9F, 0, 0, 1}, unclipped) == TriangleVerdict::too_large);
}

TEST_CASE("a triangle that touches the view volume in a corner is outside", "[pipeline][clip]") {
    // Each vertex is outside one plane only, so outcodes cannot tell
    CHECK(verdict_on({1, 1.5F, 0, 1}, {1.5F, 1, 0, 1}, {2, 2, 0, 1}) == TriangleVerdict::outside);
}

TEST_CASE("vertices with w = 0 are clipped away", "[pipeline][clip]") {
    CHECK(
        verdict_on({-0.5F, -0.5F, 0, 1}, {0.5F, -0.5F, 0, 1}, {0, 1, 0, 0}) ==
        TriangleVerdict::drawn
    );
    CHECK(verdict_on({-1, -1, 0, 0}, {1, -1, 0, 0}, {0, 1, 0, 0}) != TriangleVerdict::drawn);
    CHECK(verdict_on({0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}) != TriangleVerdict::drawn);
}

TEST_CASE("a triangle wholly behind the eye is outside, not mirrored", "[pipeline][clip]") {
    CHECK(
        verdict_on({0.5F, 0.5F, 0, -1}, {-0.5F, 0.5F, 0, -1}, {0, -0.5F, 0, -1}) ==
        TriangleVerdict::outside
    );
}

TEST_CASE("no vertex that is infinite or not a number is drawn from", "[pipeline]") {
    const glm::vec4 a{-0.5F, -0.5F, 0, 1};
    const glm::vec4 b{0.5F, -0.5F, 0, 1};
    for (const bool clip : {true, false}) {
        scene::Settings settings = settings_of(16, 16);
        settings.clip_enabled = clip;
        for (int coordinate = 0; coordinate < 4; ++coordinate) {
            for (const float bad : {not_a_number, infinity, -infinity}) {
                glm::vec4 c{0, 0.5F, 0, 1};
                c[coordinate] = bad;
                INFO("clipping " << clip << ", coordinate " << coordinate << " is " << bad);
                CHECK(verdict_on(a, b, c, settings) != TriangleVerdict::drawn);
                CHECK(verdict_on(c, c, c, settings) != TriangleVerdict::drawn);
            }
        }
    }
}

TEST_CASE(
    "without clipping, 1/w = 0 between front and back has a color all the same", "[pipeline]"
) {
    scene::Settings settings = settings_of(8, 8);
    settings.clip_enabled = false;
    // Halfway between w = 1 and w = −1, on pixel centers, 1/w is exactly 0
    const tests::Soup soup{
        {{-0.875F, 0.875F, 0, 1}, red},
        {{-0.125F, -0.875F, 0, -1}, red},
        {{-0.875F, -0.875F, 0, 1}, red}};
    const Outcome result = outcome(soup, settings);
    CHECK(result.verdicts.front() == TriangleVerdict::drawn);
}

TEST_CASE("every fate is reached, and every fragment has one", "[pipeline]") {
    scene::Settings settings = settings_of(8, 8);
    settings.scissor = PixelRect{2, 0, 8, 8};
    const tests::Soup soup = joined(full_screen(-0.5F, red), full_screen(0.5F, white));
    Outcome result = outcome(soup, settings);
    CHECK(result.fates[FragmentFate::written] == 48);
    CHECK(result.fates[FragmentFate::depth_failed] == 48);
    CHECK(result.fates[FragmentFate::scissor_failed] == 32);

    settings.visibility = scene::Visibility::bsp;
    settings.bsp_order = scene::BspOrder::front_to_back;
    Outcome front_to_back = outcome(soup, settings);
    CHECK(front_to_back.fates[FragmentFate::written] == 48);
    CHECK(front_to_back.fates[FragmentFate::pixel_closed] == 48);
    result.fates.merge(front_to_back.fates);
    CHECK(result.fates.size() == fragment::fate_count);
}

TEST_CASE("early depth tests save shading and change no pixel", "[pipeline]") {
    scene::Settings settings = settings_of(8, 8);
    const tests::Soup soup = joined(full_screen(-0.5F, red), full_screen(0.5F, white));
    std::uint64_t late_digest = 0;
    std::uint64_t early_digest = 0;
    const Outcome late = outcome(soup, settings, &late_digest);
    settings.depth_order = scene::DepthOrder::early;
    const Outcome early = outcome(soup, settings, &early_digest);
    CHECK(late.shaded_fragments == 128);
    CHECK(early.shaded_fragments == 64);
    CHECK(early_digest == late_digest);
}

TEST_CASE("depth complexity sums to the number of fragments", "[pipeline]") {
    const tests::Soup soup = joined(full_screen(-0.5F, red), full_screen(0.5F, white));
    const tests::Drawing drawing = tests::drawn(tests::soup_scene(soup, settings_of(7, 5)));
    CHECK(std::accumulate(drawing.covered.begin(), drawing.covered.end(), 0) == 2 * 35);
    CHECK(std::ranges::count(drawing.covered, 2) == 35);
}

TEST_CASE("the nearer surface wins, whichever is drawn first", "[pipeline][depth]") {
    for (const bool near_first : {true, false}) {
        const tests::Soup near = full_screen(-0.5F, red);
        const tests::Soup far = full_screen(0.5F, white);
        const auto scene = tests::soup_scene(
            near_first ? joined(near, far) : joined(far, near), settings_of(4, 4)
        );
        const tests::Drawing drawing = tests::drawn(scene);
        CHECK(drawing.target.color({1, 2}) == red);
        CHECK(drawing.target.depth({1, 2}) == 0.25F);
    }
}

TEST_CASE("reversed depth keeps the greater value by default", "[pipeline][depth]") {
    scene::Settings settings = settings_of(4, 4);
    settings.depth_convention = scene::DepthConvention::reversed;
    const auto scene =
        tests::soup_scene(joined(full_screen(0.25F, white), full_screen(0.75F, red)), settings);
    const tests::Drawing drawing = tests::drawn(scene);
    CHECK(drawing.target.color({1, 2}) == red);
    CHECK(drawing.target.depth({1, 2}) == 0.75F);
}

TEST_CASE("flat interpolation takes the last vertex, through clipping too", "[pipeline]") {
    scene::Settings settings = settings_of(8, 8);
    settings.interpolation = scene::InterpolationKind::flat;
    for (const float reach : {1.0F, 3.0F}) { // 3: every side is crossed
        tests::Soup soup = full_screen(0.0F, white);
        for (std::size_t i = 0; i < soup.size(); ++i) {
            soup[i].clip.x *= reach;
            soup[i].clip.y *= reach;
            soup[i].color = i % 3 == 2 ? red : white;
        }
        const tests::Drawing drawing = tests::drawn(tests::soup_scene(soup, settings));
        for (std::size_t i = 0; i < drawing.triangle.size(); ++i) {
            REQUIRE(drawing.target.color(drawing.pixel(i)) == red);
        }
    }
}

TEST_CASE("a scope of units draws just those rows", "[pipeline]") {
    scene::Settings settings = settings_of(6, 6);
    settings.traversal = scene::TraversalKind::brute_force;
    pipeline::Frame frame(tests::soup_scene(full_screen(0.0F, red), settings));
    framebuffer::Framebuffer target(settings);
    pipeline::NullTrace nothing;
    pipeline::run_vertex_stage(frame.calls().front(), nothing);
    for (std::uint32_t triangle = 0; triangle < 2; ++triangle) {
        pipeline::draw_triangle(frame.calls().front(), triangle, {0, 2, 0, 4}, target, nothing);
    }
    for (int y = 0; y < 6; ++y) {
        const bool drawn = y == 2 || y == 3;
        CHECK(target.color({3, y}) == (drawn ? red : settings.background));
    }
}

TEST_CASE("threads change nothing, neither of vertices nor of rows", "[pipeline]") {
    tests::Soup soup;
    for (int i = 0; i < 5000; ++i) {
        const float x = static_cast<float>(i % 71) / 35.0F - 1.0F;
        soup.push_back({{x, 0.9F - x * x, 0.0F, 1.0F}, red});
        soup.push_back({{x + 0.1F, -0.5F, 0.1F, 1.0F}, white});
        soup.push_back({{x, x, 0.2F, 1.0F}, red});
    }
    const auto scene = tests::soup_scene(soup, settings_of(32, 32));
    std::vector<std::uint64_t> digests;
    for (const unsigned threads : {1U, 2U, 5U}) {
        pipeline::Frame frame(scene);
        framebuffer::Framebuffer target(scene->settings);
        pipeline::NullTrace nothing;
        pipeline::draw_frame(frame, target, nothing, threads);
        digests.push_back(target.digest());
    }
    CHECK(digests[1] == digests[0]);
    CHECK(digests[2] == digests[0]);
}

TEST_CASE(
    "within the guard band nothing is cut, and nothing is drawn beyond the image", "[pipeline]"
) {
    // Reaches three view volumes to every side; all of it lies between near and far
    const tests::Soup soup{
        {{-3.0F, -2.5F, 0.0F, 1.0F}, red},
        {{3.0F, -1.0F, 0.5F, 1.0F}, white},
        {{0.3F, 3.0F, 0.2F, 1.0F}, red}};
    scene::Settings settings = settings_of(37, 23);
    settings.guard_band = 3.0F;
    const auto guarded = trace::record(tests::soup_scene(soup, settings)).value();
    CHECK(guarded->counters.clipped == 0);

    // Where every vertex is in front of the eye, not clipping at all draws the very same picture
    settings.clip_enabled = false;
    const auto unclipped = trace::record(tests::soup_scene(soup, settings)).value();
    CHECK(guarded->digest() == unclipped->digest());
    CHECK(guarded->fragments.size() > 100);

    settings.clip_enabled = true;
    settings.guard_band = 2.0F;
    CHECK(trace::record(tests::soup_scene(soup, settings)).value()->counters.clipped == 1);
}
