// Keys that move the playhead.
#include "app/viewer/layout.hpp"
#include "tests/app/window.hpp"
#include "tests/support/catch.hpp"

#include <algorithm>

using namespace hs;
using test::Window;
using viewer::Key;

namespace {

/// Where a stage's cell of the strip is, in frames that order nothing.
float middle_of(const viewer::Rect& strip, trace::Stage stage) {
    const std::vector<trace::Stage> stages = viewer::strip_stages({});
    const auto cell = std::find(stages.begin(), stages.end(), stage) - stages.begin();
    return strip.width * (static_cast<float>(cell) + 0.5F) / static_cast<float>(stages.size());
}

} // namespace

TEST_CASE("→ steps at the chosen granularity and ← takes it back", "[app]") {
    const auto window = Window::with_scene();
    window->key(Key::home);
    REQUIRE(window->step() == 0);
    std::vector<trace::StepId> stops{0};
    for (int i = 0; i < 6; ++i) {
        window->key(Key::right);
        CHECK(window->step() > stops.back());
        stops.push_back(window->step());
    }
    for (std::size_t i = stops.size() - 1; i-- > 0;) {
        window->key(Key::left);
        CHECK(window->step() == stops[i]);
    }
}

TEST_CASE("Shift reverses a stepping key", "[app]") {
    const auto window = Window::with_scene();
    window->key(Key::home);
    window->key(Key::period);
    window->key(Key::period);
    CHECK(window->step() == 2);
    window->key(Key::period, false, true);
    CHECK(window->step() == 1);
    window->key(Key::comma, false, true);
    CHECK(window->step() == 2);
}

TEST_CASE("↑ and ↓ choose the granularity and stop at its ends", "[app]") {
    const auto window = Window::with_scene();
    REQUIRE(window->state().granularity == trace::Granularity::triangle);
    window->key(Key::down);
    CHECK(window->state().granularity == trace::Granularity::scanline);
    for (int i = 0; i < 5; ++i) {
        window->key(Key::down);
    }
    CHECK(window->state().granularity == trace::Granularity::operation);
    for (int i = 0; i < 9; ++i) {
        window->key(Key::up);
    }
    CHECK(window->state().granularity == trace::Granularity::stage);
}

TEST_CASE("Home shows the cleared framebuffer and End the finished one", "[app]") {
    const auto window = Window::with_scene();
    window->key(Key::home);
    CHECK(window->viewer.document().player().counters() == trace::Counters{});
    window->key(Key::end);
    CHECK(window->step() == window->viewer.document().player().end());
}

TEST_CASE("Space plays until the end and pauses there", "[app]") {
    const auto window = Window::with_scene();
    window->key(Key::home);
    window->key(Key::space);
    REQUIRE(window->state().playing);
    for (int i = 0; i < 100 && window->state().playing; ++i) {
        window->host.frame(window->viewer, 1.0F);
    }
    CHECK_FALSE(window->state().playing);
    CHECK(window->step() == window->viewer.document().player().end());
}

TEST_CASE("a click on a stage of the strip goes to that stage", "[app]") {
    const auto window = Window::with_scene();
    window->key(Key::home);
    const viewer::Rect strip = window->viewer.layout().strip;
    for (const trace::Stage stage :
         {trace::Stage::clip, trace::Stage::setup, trace::Stage::merge, trace::Stage::vertex}) {
        const float x = middle_of(strip, stage);
        window->click({x, strip.y + strip.height * 0.5F});
        const trace::StepKind kind = window->viewer.document().player().current().kind;
        CHECK(trace::stage_of(kind) == stage);
    }
}

TEST_CASE("a click on an earlier stage stays with the triangle", "[app]") {
    const auto window = Window::with_scene();
    REQUIRE_FALSE(window->viewer.go_to("object 1 / triangle 0 / fragment 12,7 / depth test"));
    window->settle();
    const viewer::Rect strip = window->viewer.layout().strip;
    for (const trace::Stage stage : {trace::Stage::setup, trace::Stage::clip}) {
        const float x = middle_of(strip, stage);
        window->click({x, strip.y + strip.height * 0.5F});
        const trace::Step& step = window->viewer.document().player().current();
        CHECK(trace::stage_of(step.kind) == stage);
        CHECK(step.object == 1);
        CHECK(step.triangle == 0);
    }
    const float x = middle_of(strip, trace::Stage::vertex);
    const trace::VertexDetail* corner = window->viewer.document().vertex_detail(0);
    REQUIRE(corner != nullptr);
    const std::uint32_t vertex = corner->vertex;
    window->click({x, strip.y + strip.height * 0.5F});
    const trace::Step& step = window->viewer.document().player().current();
    CHECK(step.in_vertex_stage());
    CHECK(step.object == 1);
    CHECK(step.vertex == vertex);
}

TEST_CASE("the inspector comes along from vertices to triangles to fragments", "[app]") {
    using viewer::InspectorTab;
    const auto window = Window::with_scene();
    const auto tab_at = [&](const char* step) {
        REQUIRE_FALSE(window->viewer.go_to(step));
        window->settle();
        return window->state().tab;
    };
    CHECK(tab_at("vertex stage / object 0 / vertex 1") == InspectorTab::vertex);
    CHECK(tab_at("object 0 / triangle 0 / outcodes") == InspectorTab::triangle);
    CHECK(tab_at("object 0 / triangle 0 / fragment 8,14 / depth test") == InspectorTab::fragment);
    // What was chosen by hand stays within a kind of step
    window->viewer.state().tab = InspectorTab::triangle;
    CHECK(tab_at("object 0 / triangle 0 / fragment 9,14 / depth test") == InspectorTab::triangle);
    // and on tabs about something else
    window->viewer.state().tab = InspectorTab::state;
    CHECK(tab_at("object 0 / triangle 0 / setup") == InspectorTab::state);
}

TEST_CASE("dragging along the timeline scrubs", "[app]") {
    const auto window = Window::with_scene();
    const viewer::Rect timeline = window->viewer.layout().timeline;
    const float y = timeline.y + 24.0F;
    window->host.move_mouse(timeline.width * 0.5F, y);
    window->host.press(host::MouseButton::left);
    window->settle();
    const trace::StepId middle = window->step();
    window->host.move_mouse(timeline.width * 0.75F, y);
    window->host.release(host::MouseButton::left);
    window->settle();
    CHECK(middle > 0);
    CHECK(window->step() > middle);
}

TEST_CASE("Ctrl+G goes to a written step and says what does not exist", "[app]") {
    const auto window = Window::with_scene();
    window->key(Key::g, true);
    REQUIRE(window->state().prompt == viewer::Prompt::go_to);
    window->host.text("object 9");
    window->key(Key::enter);
    CHECK(window->state().prompt == viewer::Prompt::go_to);
    CHECK_FALSE(window->state().prompt_error.empty());
    window->key(Key::escape);
    CHECK(window->state().prompt == viewer::Prompt::none);

    window->key(Key::g, true);
    window->host.text("#7");
    window->key(Key::enter);
    CHECK(window->state().prompt == viewer::Prompt::none);
    CHECK(window->step() == 7);
}

TEST_CASE("keys typed into a field do not step", "[app]") {
    const auto window = Window::with_scene();
    const trace::StepId before = window->step();
    window->key(Key::g, true);
    window->key(Key::left);
    window->key(Key::home);
    CHECK(window->step() == before);
}
