#include "core/explain/formulas.hpp"
#include "core/explain/sentence.hpp"
#include "core/pipeline/draw_frame.hpp"
#include "core/scene/scene_file.hpp"
#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/fresh_run.hpp"
#include "tests/support/paths.hpp"

#include <cmath>
#include <set>

using namespace hs;
using geometry::TriangleVerdict;

namespace {

std::shared_ptr<const scene::Scene>
parsed(std::string_view text, const std::vector<scene::Assignment>& changes = {}) {
    const auto scene = scene::parse_scene(text, "lines.toml", changes);
    REQUIRE(scene);
    return std::make_shared<const scene::Scene>(*scene);
}

std::shared_ptr<const trace::Recording>
recorded(std::string_view text, const std::vector<scene::Assignment>& changes = {}) {
    return trace::record(parsed(text, changes)).value();
}

/// On 8 × 8 pixels: a line from the center of pixel (0, 7) to that of (7, 7), from depth 0 to 1 and
/// from black to red, whose end lies twice as far from the eye.
constexpr std::string_view level = R"(
[settings]
size = [8, 8]
color.format = "rgba32f"
depth.test = "lequal"
[camera]
projection = { kind = "identity" }
[[object]]
vertices = [[-0.875, -0.875, -1, 1], [1.75, -1.75, 2, 2]]
lines = [[0, 1]]
colors = [[0, 0, 0], [1, 0, 0]]
)";

std::shared_ptr<const scene::Scene> fan(const std::vector<scene::Assignment>& changes = {}) {
    const auto path = test::source_dir() / "lessons" / "scenes" / "lines-and-points.toml";
    const auto scene = scene::load_scene(path, changes);
    REQUIRE(scene);
    return std::make_shared<const scene::Scene>(*scene);
}

} // namespace

TEST_CASE("depth runs linearly along a line, varyings in perspective", "[pipeline][line]") {
    const auto recording = recorded(level);
    REQUIRE(recording->fragments.size() == 8);
    for (std::uint32_t i = 0; i < 8; ++i) {
        const trace::FragmentRecord& fragment = recording->fragments[i];
        const float t = static_cast<float>(i) / 7.0F;
        CHECK(fragment.pixel() == PixelPos{static_cast<int>(i), 7});
        CHECK(std::fabs(fragment.depth - t) < 1.0e-6F);
        // b = t·(1/2) / ((1 − t)·1 + t·(1/2)) = t / (2 − t)
        CHECK(std::fabs(recording->color32f[i].r - t / (2.0F - t)) < 1.0e-6F);
    }
    const auto straight = recorded(level, {{"interpolation", "linear"}});
    CHECK(std::fabs(straight->color32f[3].r - 3.0F / 7.0F) < 1.0e-6F);
    const auto constant = recorded(level, {{"interpolation", "flat"}});
    CHECK(constant->color32f[3].r == 1.0F); // the last vertex provokes
}

TEST_CASE("a point is the pixel that holds it", "[pipeline][line]") {
    constexpr std::string_view points = R"(
[settings]
size = [8, 8]
[camera]
projection = { kind = "identity" }
[[object]]
vertices = [[-0.99, 0.99, 0], [0, 0, 0], [0.99, -0.99, 0.5], [1.2, 0, 0]]
points = [0, 1, 2, 3]
)";
    const auto recording = recorded(points);
    REQUIRE(recording->fragments.size() == 3);
    CHECK(recording->fragments[0].pixel() == PixelPos{0, 0});
    CHECK(recording->fragments[1].pixel() == PixelPos{4, 4}); // on a corner: right and below
    CHECK(recording->fragments[2].pixel() == PixelPos{7, 7});
    CHECK(recording->fragments[2].depth == 0.75F);
    CHECK(recording->triangles[3].verdict == TriangleVerdict::outside);
    const auto step = trace::find_step(*recording, "object 0 / point 2 / fragment 7,7 / merge");
    REQUIRE(step);
    CHECK(
        trace::step_path(trace::describe_step(*recording, *step)) ==
        "object 0 / point 2 / fragment 7,7 / merge"
    );
}

TEST_CASE(
    "a line is clipped to the part inside, by the parameter of Liang and Barsky", "[pipeline][line]"
) {
    // From x = −2 to x = 2: inside from t = 1/4 to 3/4, which is where colors 1/4 and 3/4 lie
    constexpr std::string_view across = R"(
[settings]
size = [8, 8]
color.format = "rgba32f"
[camera]
projection = { kind = "identity" }
[[object]]
vertices = [[-2, 0.125, 0], [2, 0.125, 0]]
lines = [[0, 1]]
colors = [[0, 0, 0], [1, 0, 0]]
)";
    const auto recording = recorded(across);
    const trace::TriangleDetail detail = trace::triangle_detail(*recording, 0, 0);
    REQUIRE(detail.passes.size() == 2);
    const geometry::ClipPolygon& left = detail.passes.back().after;
    REQUIRE(left.count == 2);
    CHECK(left[0].position.x == -1.0F);
    CHECK(left[1].position.x == 1.0F);
    CHECK(left[0].varyings[0] == 0.25F);
    CHECK(left[1].varyings[0] == 0.75F);
    CHECK(recording->fragments.size() == 8);
    CHECK(recording->triangles[0].verdict == TriangleVerdict::drawn);
    for (std::uint32_t i = 0; i < 8; ++i) {
        const float x = (static_cast<float>(i) + 0.5F) / 8.0F;
        CHECK(std::fabs(recording->color32f[i].r - (0.25F + 0.5F * x)) < 1.0e-3F);
    }
}

TEST_CASE(
    "a line behind the eye is invisible, one through it is cut at the near plane",
    "[pipeline][line]"
) {
    constexpr std::string_view from_the_eye = R"(
[settings]
size = [16, 16]
[camera]
eye = [0, 0, 0]
target = [0, 0, -1]
[[object]]
vertices = [[0.1, 0.1, 2], [0.1, 0.1, 1], [0.5, 0.5, -3]]
lines = [[0, 1], [1, 2]]
)";
    const auto recording = recorded(from_the_eye);
    CHECK(recording->triangles[0].verdict == TriangleVerdict::outside);
    CHECK(recording->triangles[1].verdict == TriangleVerdict::drawn);
    const auto wrapped = recorded(from_the_eye, {{"clip.enabled", "false"}});
    CHECK(wrapped->digest() != recording->digest());
}

TEST_CASE(
    "triangles, lines and points meet the same depth buffer in file order", "[pipeline][line]"
) {
    constexpr std::string_view mixed = R"(
[settings]
size = [8, 8]
[camera]
projection = { kind = "identity" }
[[object]]
vertices = [[-1, -1, 0], [1, -1, 0], [-1, 1, 0], [-1, 0.1, -0.5], [1, 0.1, 0.5], [0.8, 0.8, 0]]
polygons = [[0, 1, 2]]
lines = [[3, 4]]
points = [5]
)";
    const auto recording = recorded(mixed);
    REQUIRE(recording->triangles.size() == 3);
    const auto owner = [&](int x, int y) { return recording->final_pixels[{x, y}].triangle; };
    CHECK(owner(0, 7) == 0);
    CHECK(owner(0, 3) == 1); // in front of the triangle
    CHECK(owner(7, 3) == 1); // behind it, but it does not reach here
    CHECK(owner(7, 0) == 2);
    std::set<scene::PrimitiveKind> kinds;
    for (trace::StepId id = 0; id <= recording->end_step; ++id) {
        const trace::Step step = trace::describe_step(*recording, id);
        const auto again = trace::find_step(*recording, trace::step_path(step));
        REQUIRE(again);
        CHECK(*again == id);
        if (step.in_triangle()) {
            kinds.insert(step.primitive);
        }
    }
    CHECK(kinds.size() == 3);
}

TEST_CASE("every step of lines and points equals a fresh run stopped there", "[pipeline][line]") {
    for (const char* const algorithm : {"bresenham", "dda"}) {
        const auto scene = fan({{"line.algorithm", algorithm}});
        const std::vector<tests::Moment> moments = tests::fresh_run(scene);
        trace::Player player{trace::record(scene).value()};
        REQUIRE(moments.size() == player.end() + 1);
        for (const bool backward : {false, true}) {
            for (std::size_t i = 0; i < moments.size(); i += 3) {
                const std::size_t at = backward ? moments.size() - 1 - i : i;
                player.seek(at);
                REQUIRE(player.current().kind == moments[at].kind);
                REQUIRE(tests::shown_digest(player) == moments[at].framebuffer);
                REQUIRE(player.counters() == moments[at].counters);
            }
        }
    }
}

TEST_CASE("threads that share the rows draw the same lines", "[pipeline][line]") {
    const auto scene = fan();
    const auto digest = [&scene](unsigned threads) {
        pipeline::Frame frame(scene);
        framebuffer::Framebuffer target(scene->settings);
        pipeline::NullTrace nothing;
        pipeline::draw_frame(frame, target, nothing, threads);
        return target.digest();
    };
    CHECK(digest(3) == digest(1));
    CHECK(trace::record(scene).value()->digest() == digest(1));
}

TEST_CASE("every step of a line has a sentence and a formula", "[pipeline][line]") {
    for (const char* const algorithm : {"bresenham", "dda"}) {
        trace::Player player{trace::record(fan({{"line.algorithm", algorithm}})).value()};
        for (trace::StepId id = player.recording().first_triangle_step; id < player.end(); ++id) {
            player.seek(id);
            const trace::Step& step = player.current();
            INFO(trace::step_path(step));
            CHECK(explain::sentence(player).find("triangle") == std::string::npos);
            const auto list =
                explain::formulas(player.detail(), step, player.recording().settings());
            REQUIRE_FALSE(list.empty());
            CHECK_FALSE(list.front().value.empty());
        }
    }
}

TEST_CASE("what is wrong with a line is said where it stands", "[pipeline][line]") {
    const auto complaint = [](const std::string& primitives) {
        const std::string text =
            "[[object]]\nvertices = [[0, 0, 0], [1, 0, 0]]\n" + primitives + "\n";
        const auto scene = scene::parse_scene(text, "bad.toml");
        REQUIRE_FALSE(scene);
        return scene.diagnostics().front().to_string();
    };
    CHECK(complaint("lines = [[0]]") == "bad.toml:3:10: a line must be a list of 2 vertex numbers");
    CHECK(complaint("lines = [[0, 2]]").find("there is no vertex 2") != std::string::npos);
    CHECK(complaint("points = [0.5]") == "bad.toml:3:11: a point must be the number of a vertex");
    CHECK(complaint("").find("no polygons, lines or points") != std::string::npos);
}
