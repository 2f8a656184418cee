#include "core/explain/clip_story.hpp"

#include "core/scene/scene_file.hpp"
#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

#include <cmath>

using namespace hs;
using explain::OutcodeVerdict;

namespace {

trace::TriangleDetail first_triangle(std::string_view vertices, std::string_view settings = "") {
    const std::string text =
        std::string{"[settings]\nsize = [16, 16]\n"} + std::string{settings} +
        "\n[camera]\nprojection = { kind = \"identity\" }\n[[object]]\n"
        "name = \"one\"\nvertices = " +
        std::string{vertices} +
        "\npolygons = [[0, 1, 2]]\ncolors = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n";
    const Result<scene::Scene> scene = scene::parse_scene(text, "test.toml");
    REQUIRE(scene);
    const auto recording = trace::record(std::make_shared<const scene::Scene>(*scene));
    REQUIRE(recording);
    return trace::triangle_detail(**recording, 0, 0);
}

} // namespace

TEST_CASE("outcodes accept, reject, or leave it to clipping", "[explain]") {
    const auto verdict = [](std::string_view vertices) {
        return explain::outcode_verdict(first_triangle(vertices).outcodes);
    };
    CHECK(verdict("[[0, 0, 0], [0.5, 0, 0], [0, 0.5, 0]]") == OutcodeVerdict::accepted);
    CHECK(verdict("[[2, 0, 0], [3, 0, 0], [2, 0.5, 0]]") == OutcodeVerdict::rejected);
    CHECK(verdict("[[0, 0, 0], [3, 0, 0], [0, 0.5, 0]]") == OutcodeVerdict::undecided);
    // Outside, yet not of one plane: only clipping finds out
    CHECK(verdict("[[0, 3, 0], [3, 0, 0], [3, 3, 0]]") == OutcodeVerdict::undecided);
}

TEST_CASE("planes are named in the order they clip", "[explain]") {
    const trace::TriangleDetail triangle = first_triangle("[[0, 0, 0], [3, 0, 0], [0, 3, 0]]");
    const unsigned any =
        static_cast<unsigned>(triangle.outcodes[0]) | triangle.outcodes[1] | triangle.outcodes[2];
    CHECK(explain::plane_names(static_cast<geometry::Outcode>(any)) == "right, top");
    CHECK(explain::plane_names(0).empty());
}

TEST_CASE("a cut lies where the distance is 0, and its attributes with it", "[explain]") {
    const trace::TriangleDetail triangle = first_triangle("[[0, 0, 0], [2, 0, 0], [0, 0.5, 0]]");
    scene::Settings settings;
    const auto story = explain::clip_story(triangle, settings);
    REQUIRE(story.size() == 1);
    CHECK(story[0].plane == geometry::ClipPlane::right);
    CHECK(story[0].distances == std::vector<float>{1.0F, -1.0F, 1.0F}); // w − x
    REQUIRE(story[0].cuts.size() == 2);
    for (const explain::ClipCut& cut : story[0].cuts) {
        CHECK(cut.outside == 1);
        CHECK(cut.t == Approx(0.5));
        CHECK(cut.made.position.x == Approx(1.0));
        CHECK(cut.made.varyings.color().g == Approx(0.5)); // half way to the green vertex
    }
}

TEST_CASE("the story's vertices are those the pipeline made", "[explain]") {
    const trace::TriangleDetail triangle =
        first_triangle("[[-3, 0.2, 0.5], [2.5, -4, 0], [0.3, 3, -3]]");
    const auto story = explain::clip_story(triangle, scene::Settings{});
    REQUIRE(story.size() == triangle.passes.size());
    REQUIRE(story.size() > 2);
    for (std::size_t i = 0; i < story.size(); ++i) {
        const geometry::ClipPolygon& after = triangle.passes[i].after;
        CHECK(story[i].plane == triangle.passes[i].plane);
        for (const explain::ClipCut& cut : story[i].cuts) {
            CHECK((cut.t >= 0.0F && cut.t < 1.0F));
            bool found = false;
            for (int k = 0; k < after.count; ++k) {
                found = found || after[k].position == cut.made.position;
            }
            CHECK(found);
        }
    }
}

TEST_CASE("vertices at and behind the eye are the reason to clip", "[explain]") {
    CHECK(explain::reasons_to_clip(first_triangle("[[0, 0, 0], [1, 0, 0], [0, 1, 0]]")).empty());
    const auto reasons = explain::reasons_to_clip(
        first_triangle("[[0, 0, 0, 1], [1, 2, 0, -2], [0, 1, 0, 0]]", "clip.enabled = false")
    );
    REQUIRE(reasons.size() == 2);
    CHECK(reasons[0].find("behind the eye") != std::string::npos);
    CHECK(reasons[0].find("(-0.5000, -1.0000)") != std::string::npos);
    CHECK(reasons[1].find("w = 0") != std::string::npos);
}
