#include "core/explain/traversal.hpp"

#include "core/explain/sentence.hpp"
#include "core/scene/scene_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

#include <fmt/format.h>

using namespace hs;

namespace {

/// One triangle over 16 × 16 pixels; its vertices lie on the centers of pixels (0, 15), (15, 15)
/// and (0, 0).
trace::Player player(std::string_view traversal, float w_of_last = 1.0F) {
    const std::string text = fmt::format(
        R"(
[settings]
size = [16, 16]
traversal = "{}"
[camera]
projection = {{ kind = "identity" }}
[[object]]
vertices = [[-0.9375, -0.9375, 0], [0.9375, -0.9375, 0], [-0.9375, 0.9375, 0, {}]]
polygons = [[0, 1, 2]]
)",
        traversal,
        w_of_last
    );
    const Result<scene::Scene> scene = scene::parse_scene(text, "test.toml");
    REQUIRE(scene);
    const auto recording = trace::record(std::make_shared<const scene::Scene>(*scene));
    REQUIRE(recording);
    return trace::Player{*recording};
}

void stand_on(trace::Player& at, std::string_view path) {
    const Result<trace::StepId> step = trace::find_step(at.recording(), path);
    INFO(path);
    REQUIRE(step);
    at.seek(*step);
}

std::string sentence_at(std::string_view traversal, std::string_view path) {
    trace::Player at = player(traversal);
    stand_on(at, path);
    return explain::sentence(at);
}

std::vector<explain::Formula> formulas_at(trace::Player& at, std::string_view path) {
    stand_on(at, path);
    return explain::formulas(at.detail(), at.current(), at.recording().settings());
}

} // namespace

TEST_CASE("a tile is told with its verdict and the edges behind it", "[explain][traversal]") {
    CHECK(
        sentence_at("hierarchical", "triangle 0 / tile 0,0 size 8") ==
        "Tile (0, 0) of 8 × 8 pixels is partial: its corners disagree about E12 of triangle 0."
    );
    CHECK(
        sentence_at("hierarchical", "triangle 0 / tile 4,0 size 4") ==
        "Tile (4, 0) of 4 × 4 pixels is rejected: all four corners lie outside E12 of triangle 0."
    );
}

TEST_CASE("a tile without a size is the smallest one there", "[explain][traversal]") {
    trace::Player at = player("hierarchical");
    stand_on(at, "triangle 0 / tile 8,8");
    CHECK(at.current().tile_size == 4);
}

TEST_CASE("a span is told with both edges and its pixels", "[explain][traversal]") {
    CHECK(
        sentence_at("edge-walk", "triangle 0 / scanline 5 / span") ==
        "Scanline 5 of triangle 0 runs from E20 at x = 0.5000 to E12 at x = 5.5000: it covers "
        "pixels 0 to 4."
    );
    CHECK(
        sentence_at("edge-walk", "triangle 0 / scanline 0 / span") ==
        "Scanline 0 of triangle 0 runs from E20 at x = 0.5000 to E12 at x = 0.5000: no pixel "
        "center lies between."
    );
}

TEST_CASE("tables of edges are told with their entries in order", "[explain][traversal]") {
    CHECK(
        sentence_at("edge-table", "triangle 0 / edge table") ==
        "The edges of triangle 0 go into buckets: E20 at scanline 0, E12 at scanline 0."
    );
    CHECK(
        sentence_at("edge-table", "triangle 0 / scanline 3 / active edges") ==
        "Scanline 3 of triangle 0: 0 edges enter, 0 leave; active are E20 at x = 0.5000 and E12 at "
        "x = 3.5000."
    );
}

TEST_CASE(
    "a running edge value is told with the addition that changed it", "[explain][traversal]"
) {
    trace::Player incremental = player("incremental");
    const auto right = formulas_at(incremental, "triangle 0 / pixel 5,3");
    CHECK(right.at(2).symbolic == "E = E at (4, 3) + a");
    CHECK(right.at(2).with_numbers == "60.0000 + 15.0000 px²"); // x · 15 px of height
    CHECK(
        formulas_at(incremental, "triangle 0 / pixel 0,3").at(2).title == "E20 from pixel (0, 2)"
    );
    trace::Player serpentine = player("serpentine");
    const auto left = formulas_at(serpentine, "triangle 0 / pixel 5,3");
    CHECK(left.at(2).symbolic == "E = E at (6, 3) − a");
}

TEST_CASE("a plane test is told with 1/w", "[explain][traversal]") {
    trace::Player at = player("homogeneous", 2.0F);
    stand_on(at, "triangle 0 / pixel 1,12");
    CHECK(explain::sentence(at).find("with 1/w = ") != std::string::npos);
    trace::Player behind = player("homogeneous", -0.5F);
    stand_on(behind, "triangle 0 / cull");
    CHECK(explain::sentence(behind).find("reaches behind the eye") != std::string::npos);
    stand_on(behind, "triangle 0 / pixel 15,0");
    CHECK(explain::sentence(behind).find("< 0") != std::string::npos);
}

TEST_CASE("every step of every traversal has a sentence and a place", "[explain][traversal]") {
    tests::Random random(91);
    for (std::uint64_t seed = 0; seed < 120; ++seed) {
        const auto recording = trace::record(tests::random_scene(seed));
        REQUIRE(recording);
        trace::Player at(*recording);
        for (int i = 0; i < 60; ++i) {
            at.seek(random.next() % (at.end() + 1));
            const std::string path = trace::step_path(at.current());
            INFO("seed " << seed << ", " << path);
            const std::string sentence = explain::sentence(at);
            CHECK(sentence.ends_with('.'));
            CHECK(sentence != path + ".");
            const auto list =
                explain::formulas(at.detail(), at.current(), at.recording().settings());
            const bool computes = at.current().in_unit() && !at.current().in_fragment();
            CHECK((!computes || !list.empty()));
        }
    }
}
