// Every number explains itself, in the window: the tab of values, the way back from a color, and
// changes that can be undone.
#include "tests/app/window.hpp"
#include "tests/support/catch.hpp"

#include <algorithm>

using namespace hs;
using test::Window;
using viewer::InspectorTab;
using viewer::Key;

namespace {

std::string path(const Window& window) {
    return trace::step_path(window.viewer.document().player().current());
}

} // namespace

TEST_CASE("the keyboard alone follows a value to where it came from, and back", "[app]") {
    const auto window = Window::with_scene();
    const std::string test = "object 1 / triangle 1 / fragment 3,3 / depth test";
    REQUIRE_FALSE(window->viewer.go_to(test));
    window->settle();
    CHECK(
        window->viewer.why_not(viewer::Command::follow_operand) ==
        "No value is open: E opens the step's values one by one."
    );

    window->key(Key::e); // fragment depth
    window->settle();
    CHECK(window->state().tab == InspectorTab::values);
    CHECK(window->state().values.open == "fragment depth");
    window->key(Key::o); // depth, of interpolation
    window->key(Key::l);
    window->settle();
    CHECK(path(*window) == "object 1 / triangle 1 / fragment 3,3 / interpolate");
    CHECK(window->state().values.open == "depth");
    window->key(Key::o);
    window->key(Key::l);
    window->settle();
    CHECK(path(*window) == "object 1 / triangle 1 / viewport");
    CHECK(window->state().values.open == "v0.window.depth");

    window->key(Key::backspace);
    window->key(Key::backspace);
    window->settle();
    CHECK(path(*window) == test);
    CHECK(window->state().values.open == "fragment depth");
    CHECK(window->viewer.why_not(viewer::Command::value_back) == "No operand has been followed.");
}

TEST_CASE("why opens the picked pixel's way back and every triangle's reason", "[app]") {
    const auto window = Window::with_scene();
    window->viewer.select({8, 3});
    window->key(Key::end);
    window->key(Key::w);
    window->settle();
    CHECK(window->state().tab == InspectorTab::history);
    CHECK(window->state().show_why);
    const viewer::Reasons& reasons = window->viewer.document().reasons({8, 3});
    REQUIRE(!reasons.color.empty());
    CHECK(reasons.color.back().value.name == "clip.x");
    const auto shows = std::ranges::count(
        reasons.triangles, explain::PixelRole::shows, &explain::TriangleAtPixel::role
    );
    CHECK(shows == 1);
    window->viewer.follow({reasons.color.back().path, reasons.color.back().value.name, {}});
    window->settle();
    CHECK(window->state().tab == InspectorTab::values);
    CHECK(window->state().values.open == "clip.x");
}

TEST_CASE("a change is undone and done again, at the same step", "[app]") {
    const auto window = Window::with_scene();
    const std::string at = "object 1 / triangle 1 / setup";
    REQUIRE_FALSE(window->viewer.go_to(at));
    CHECK(window->viewer.why_not(viewer::Command::undo) == "Nothing has been changed.");
    const std::uint64_t before = window->viewer.document().recording().digest();

    scene::Settings settings = window->viewer.document().scene().settings;
    settings.background = {1.0F, 0.0F, 0.0F, 1.0F};
    settings.depth_write = !settings.depth_write;
    REQUIRE_FALSE(window->viewer.change_settings(settings));
    window->viewer.finish_background_work();
    const std::uint64_t changed = window->viewer.document().recording().digest();
    CHECK(changed != before);
    CHECK(window->state().values_before.step == at);
    CHECK(window->state().values_before.texts.at("2A") == "128.0000");

    window->key(Key::z, true);
    window->viewer.finish_background_work();
    window->settle();
    CHECK(window->viewer.document().recording().digest() == before);
    CHECK(path(*window) == at);
    CHECK(window->viewer.why_not(viewer::Command::undo) == "Nothing has been changed.");

    window->key(Key::z, true, true);
    window->viewer.finish_background_work();
    window->settle();
    CHECK(window->viewer.document().recording().digest() == changed);
    CHECK(path(*window) == at);
    CHECK(window->viewer.why_not(viewer::Command::redo) == "Nothing has been undone.");
}
