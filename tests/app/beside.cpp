// Two configurations side by side: one playhead, two frames.
#include "tests/app/window.hpp"
#include "tests/support/catch.hpp"

using namespace hs;
using test::Window;
using viewer::Key;
using viewer::SidePanel;

namespace {

std::unique_ptr<Window> with_beside(const scene::Assignment& change) {
    auto window = Window::with_scene();
    REQUIRE_FALSE(window->viewer.show_beside(change));
    window->settle();
    return window;
}

const trace::Step& step_beside(Window& window) {
    return window.viewer.beside().document().player().current();
}

/// Where the second picture shows a pixel's center.
ImVec2 beside_position(const Window& window, PixelPos pixel) {
    const ImVec2 main = window.viewer.screen_position(pixel);
    const viewer::Rect& here = window.state().screen.area;
    const viewer::Rect& there = window.state().beside.area;
    return {
        main.x + (there.x + there.width * 0.5F) - (here.x + here.width * 0.5F),
        main.y + (there.y + there.height * 0.5F) - (here.y + here.height * 0.5F)};
}

} // namespace

TEST_CASE("B shows the second frame and takes it away", "[app][beside]") {
    const auto window = with_beside({"depth.test", "greater"});
    CHECK(window->viewer.shows_beside());
    window->key(Key::b);
    CHECK_FALSE(window->viewer.shows_beside());
    CHECK(window->state().side == SidePanel::space);
    window->key(Key::b);
    CHECK(window->viewer.shows_beside());
}

TEST_CASE("both playheads stand on the same step, whichever way they came", "[app][beside]") {
    const auto window = with_beside({"traversal", "serpentine"});
    for (const char* const at :
         {"object 1 / triangle 0 / fragment 12,6 / merge",
          "vertex stage / object 1 / vertex 2",
          "object 0 / triangle 1 / fragment 3,5 / depth test",
          "start",
          "end"}) {
        REQUIRE_FALSE(window->viewer.go_to(at));
        window->settle();
        CHECK(
            trace::step_path(step_beside(*window)) ==
            trace::step_path(window->viewer.document().player().current())
        );
    }
    window->key(Key::left, true);
    CHECK(
        trace::step_path(step_beside(*window)) ==
        trace::step_path(window->viewer.document().player().current())
    );
}

TEST_CASE("a click in the second picture picks the same pixel in both", "[app][beside]") {
    const auto window = with_beside({"depth.test", "greater"});
    window->click(beside_position(*window, {5, 3}));
    REQUIRE(window->state().selected.has_value());
    CHECK(*window->state().selected == PixelPos{5, 3});
}

TEST_CASE("the second frame is recorded anew with the first", "[app][beside]") {
    const auto window = with_beside({"depth.test", "greater"});
    const auto color = [&](viewer::Document& document) { return document.player().color({4, 4}); };
    CHECK(color(window->viewer.document()).b == 1.0F);
    CHECK(color(window->viewer.beside().document()) == glm::vec4{0.0F, 0.0F, 0.0F, 1.0F});
    // Half of the picture is covered twice, all of it at least once, and greater draws nothing
    CHECK(window->viewer.beside().difference().color.size() == 256);

    scene::Settings settings = window->viewer.document().scene().settings;
    settings.depth_clear_choice = 0.0F;
    REQUIRE_FALSE(window->viewer.change_settings(settings));
    window->settle();
    CHECK(color(window->viewer.beside().document()).r == 1.0F);
    CHECK(window->viewer.beside().document().recording().settings().depth_clear() == 0.0F);
}

TEST_CASE("camera and objects can differ beside, and nothing else does", "[app][beside]") {
    const auto window =
        with_beside({"camera.projection", "{ kind = 'orthographic', height = 1.5 }"});
    REQUIRE(window->viewer.shows_beside());
    const auto expect = [&](const scene::Scene& changed) {
        const auto fresh = trace::record(std::make_shared<scene::Scene>(changed)).value();
        CHECK(window->viewer.beside().document().recording().digest() == fresh->digest());
        CHECK(window->viewer.document().recording().digest() != fresh->digest());
    };
    scene::Scene other_way = window->viewer.document().scene();
    other_way.camera.projection = {.kind = scene::ProjectionKind::orthographic, .height = 1.5F};
    expect(other_way);

    REQUIRE_FALSE(
        window->viewer.show_beside({"object.near.transform", "[{ translate = [0.5, 0, 0] }]"})
    );
    window->settle();
    REQUIRE(window->viewer.shows_beside());
    scene::Scene moved = window->viewer.document().scene();
    moved.objects[1].transform = {{.vector = {0.5F, 0.0F, 0.0F}}};
    expect(moved);
}

TEST_CASE("a camera that cannot be is refused in a sentence", "[app][beside]") {
    const auto window = Window::with_scene();
    for (const scene::Assignment& change :
         {scene::Assignment{"camera.eye", "3"},
          scene::Assignment{"camera.fov", "30"},
          scene::Assignment{"object.nobody.transform", "[]"}}) {
        REQUIRE_FALSE(window->viewer.show_beside(change));
        window->settle();
        CHECK_FALSE(window->viewer.shows_beside());
        CHECK_FALSE(window->viewer.beside().complaint().empty());
    }
}

TEST_CASE("a setting that cannot be is refused in a sentence", "[app][beside]") {
    const auto window = with_beside({"depth.test", "greater"});
    CHECK(window->viewer.show_beside({"depth.tset", "less"}).has_value());
    CHECK(window->viewer.show_beside({"traversal", "sideways"}).has_value());
    CHECK(window->viewer.show_beside({"size", "[8, 8]"}).has_value());
    REQUIRE_FALSE(window->viewer.show_beside({"viewport", "[0, 0, 99, 99]"}));
    window->settle();
    CHECK_FALSE(window->viewer.shows_beside());
    CHECK_FALSE(window->viewer.beside().complaint().empty());
}
