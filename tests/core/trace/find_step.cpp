#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/made_scene.hpp"

#include <string>

using namespace hs;

namespace {

/// One triangle over the lower left half of 4 × 4 pixels.
std::shared_ptr<const trace::Recording> one_triangle() {
    const auto scene = tests::clip_space_scene(
        {{-1.0F, -1.0F, 0.0F, 1.0F}, {1.0F, -1.0F, 0.0F, 1.0F}, {-1.0F, 1.0F, 0.0F, 1.0F}}, 4, 4
    );
    return trace::record(scene).value();
}

std::string path_of(const trace::Recording& recording, std::string_view written) {
    const auto step = trace::find_step(recording, written);
    return step ? trace::step_path(trace::describe_step(recording, *step))
                : step.diagnostics().front().message;
}

} // namespace

TEST_CASE("a path that stops early means after the last child", "[trace]") {
    const auto recording = one_triangle();
    CHECK(path_of(*recording, "vertex stage") == "vertex stage / object 0 / vertex 2 / clip space");
    CHECK(
        path_of(*recording, "object 0 / vertex 1") ==
        "vertex stage / object 0 / vertex 1 / clip space"
    );
    CHECK(trace::find_step(*recording, "object 0").value() == recording->end_step - 1);
    CHECK(trace::find_step(*recording, "object 0 / triangle 0").value() == recording->end_step - 1);
    CHECK(
        path_of(*recording, "triangle 0 / fragment 0,3") ==
        "object 0 / triangle 0 / fragment 0,3 / merge"
    );
}

TEST_CASE("parts of a path may come in any order", "[trace]") {
    const auto recording = one_triangle();
    CHECK(
        path_of(*recording, "fragment 1,2 / depth test / triangle 0 / object 0") ==
        "object 0 / triangle 0 / fragment 1,2 / depth test"
    );
    CHECK(path_of(*recording, "pixel 3,0 / triangle 0") == "object 0 / triangle 0 / pixel 3,0");
}

TEST_CASE("flat numbers, start and end name steps", "[trace]") {
    const auto recording = one_triangle();
    CHECK(trace::find_step(*recording, "start").value() == 0);
    CHECK(trace::find_step(*recording, "end").value() == recording->end_step);
    CHECK(trace::find_step(*recording, "#7").value() == 7);
}

TEST_CASE("a step that does not exist is answered with what does", "[trace]") {
    const auto recording = one_triangle();
    const auto complains = [&](std::string_view path, std::string_view about) {
        INFO(path);
        const auto step = trace::find_step(*recording, path);
        REQUIRE_FALSE(step);
        CHECK(step.diagnostics().front().message.find(about) != std::string::npos);
    };
    complains("object 1", "objects are 0 to 0");
    complains("object 0 / triangle 5", "triangles are 0 to 0");
    complains("object 0 / vertex 3", "vertices are 0 to 2");
    complains("object 0 / triangle 0 / fragment 3,0", "edge test");
    complains("object 0 / triangle 0 / clip / plane near", "no such step");
    complains("object 0 / polygon 3", "not understood");
    complains("object zero", "not understood");
    complains("object 0 / triangle 0 / fragment 1", "not understood");
    complains("#99999999", "steps are #0 to #");
    complains("#12x", "steps are #0 to #");
    complains("", "not understood");
    complains("object 0 / triangle 0 / light", "no step 'light'");
}

TEST_CASE("decisions of an ordering are named by their words and their number", "[trace]") {
    auto scene = tests::stacked_scene(3, 4, 4);
    scene->settings.visibility = scene::Visibility::painters;
    const auto recording = trace::record(scene).value();
    CHECK(path_of(*recording, "visibility") == "visibility / emit 2");
    CHECK(path_of(*recording, "visibility / comparison 1") == "visibility / comparison 1");
    CHECK(path_of(*recording, "move 0") == "visibility / move 0");
    CHECK(
        path_of(*recording, "visibility / comparison 99") ==
        "the ordering has no comparison 99; its steps of that name are 0 to 2"
    );
    CHECK(path_of(*recording, "visibility / split 0") == "the ordering has no step 'split'");
    CHECK(
        path_of(*one_triangle(), "visibility").starts_with("visibility \"z-buffer\" orders nothing")
    );
}

TEST_CASE("an order is followed by the triangles, not by their numbers", "[trace]") {
    auto scene = tests::clip_space_scene(
        {{-1, -1, -0.5F, 1},
         {1, -1, -0.5F, 1},
         {-1, 1, -0.5F, 1},
         {-1, -1, 0.5F, 1},
         {1, -1, 0.5F, 1},
         {-1, 1, 0.5F, 1}},
        4,
        4
    );
    scene->settings.visibility = scene::Visibility::painters;
    const auto recording = trace::record(scene).value();
    CHECK(recording->order.draws.front().triangle == 1);
    CHECK(recording->triangles[1].first_step < recording->triangles[0].first_step);
    CHECK(trace::find_step(*recording, "object 0 / triangle 0").value() == recording->end_step - 1);
    trace::Player player(recording);
    player.seek(recording->first_triangle_step - 1);
    player.advance(trace::Granularity::triangle, trace::Direction::forward);
    CHECK(player.current().triangle == 1);
}
