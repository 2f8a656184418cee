#include "core/explain/sentence.hpp"

#include "core/scene/scene_file.hpp"
#include "tests/support/catch.hpp"

using namespace hs;

namespace {

/// One right triangle on 8 × 8 pixels, a second one behind it, clip coordinates given directly.
constexpr std::string_view scene_text = R"(
[settings]
size = [8, 8]
[camera]
projection = { kind = "identity" }
[[object]]
name = "front"
vertices = [[-1, -1, -0.5], [1, -1, -0.5], [-1, 1, -0.5], [-1, -1, 0.5], [1, -1, 0.5], [-1, 1, 0.5],
            [-1, -1, 0], [3, -1, 0], [-1, 1, 0], [5, 5, 0], [6, 5, 0], [5, 6, 0]]
polygons = [[0, 1, 2], [3, 4, 5], [6, 7, 8], [9, 10, 11]]
)";

trace::Player player() {
    const Result<scene::Scene> scene = scene::parse_scene(scene_text, "test.toml");
    REQUIRE(scene);
    const auto recording = trace::record(std::make_shared<const scene::Scene>(*scene));
    REQUIRE(recording);
    return trace::Player{*recording};
}

/// The same, ordered by an algorithm.
trace::Player ordered_by(scene::Visibility visibility) {
    Result<scene::Scene> scene = scene::parse_scene(scene_text, "test.toml");
    REQUIRE(scene);
    scene->settings.visibility = visibility;
    const auto recording = trace::record(std::make_shared<const scene::Scene>(*scene));
    REQUIRE(recording);
    return trace::Player{*recording};
}

std::string sentence_at(std::string_view path, trace::Player at = player()) {
    const Result<trace::StepId> step = trace::find_step(at.recording(), path);
    REQUIRE(step);
    at.seek(*step);
    return explain::sentence(at);
}

} // namespace

TEST_CASE("a failed depth test is told with both numbers", "[explain]") {
    CHECK(
        sentence_at("object 0 / triangle 1 / fragment 1,6 / depth test") ==
        "Fragment (1, 6) of triangle 1 fails the depth test: 0.7500 < 0.2500 is false."
    );
}

TEST_CASE("an uncovered pixel is told with the edge that rejects it", "[explain]") {
    const std::string text = sentence_at("object 0 / triangle 0 / pixel 7,0");
    CHECK(text.find("lies outside triangle 0: E12 = ") != std::string::npos);
    CHECK(text.find("px² < 0") != std::string::npos);
}

TEST_CASE("outcodes tell inside, outside and crossing apart", "[explain]") {
    CHECK(sentence_at("object 0 / triangle 0 / outcodes").find("inside") != std::string::npos);
    CHECK(
        sentence_at("object 0 / triangle 2 / outcodes").find("must be clipped") != std::string::npos
    );
    CHECK(sentence_at("object 0 / triangle 3 / outcodes").find("invisible") != std::string::npos);
}

TEST_CASE("every step of a frame has a sentence that ends in a full stop", "[explain]") {
    trace::Player at = player();
    for (trace::StepId step = 0; step <= at.end(); ++step) {
        at.seek(step);
        const std::string text = explain::sentence(at);
        REQUIRE(text.size() > 10);
        REQUIRE(text.back() == '.');
    }
}

TEST_CASE("a comparison of keys is told with both numbers and who goes first", "[explain]") {
    CHECK(
        sentence_at("visibility / comparison 0", ordered_by(scene::Visibility::painters)) ==
        "Farthest depth 0.7500 of triangle 1 is farther than 0.2500 of triangle 0: triangle 1 goes "
        "first."
    );
}

TEST_CASE("every decision of every algorithm is told in one sentence", "[explain]") {
    for (const Named<scene::Visibility>& kind : names<scene::Visibility>()) {
        trace::Player at = ordered_by(kind.value);
        const trace::Recording& recording = at.recording();
        for (trace::StepId id = recording.first_order_step; id < recording.first_triangle_step;
             ++id) {
            at.seek(id);
            const std::string text = explain::sentence(at);
            INFO(kind.name << ": " << text);
            CHECK(text.ends_with('.'));
            CHECK((text.front() >= 'A' && text.front() <= 'Z'));
            CHECK(text.find("  ") == std::string::npos);
        }
    }
}
