// The side panel's projection, depth and clip views: readable at every size, live, and honest.
#include "app/lesson/session.hpp"
#include "tests/app/window.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

using namespace hs;
using test::Window;
using viewer::Key;
using viewer::SidePanel;

namespace {

constexpr std::string_view near_and_far = R"(
name = "clipped, and fighting"
[settings]
size = [32, 24]
depth.format = "unorm16"
[camera]
eye = [0, 0, 0]
target = [0, 0, -1]
projection = { kind = "perspective", fov_y = 60, near = 0.1, far = 1000 }
[[object]]
name = "behind the eye, too"
vertices = [[-1, -1, 1], [1, -1, -3], [0, 1, -3]]
polygons = [[0, 1, 2]]
[[object]]
name = "far"
vertices = [[-90, -90, -100], [90, -90, -100], [90, 90, -100], [-90, 90, -100]]
polygons = [[0, 1, 2, 3]]
[[object]]
name = "as far, almost"
vertices = [[-90, -90, -100.01], [90, -90, -100.01], [90, 90, -100.01], [-90, 90, -100.01]]
polygons = [[0, 1, 2, 3]]
)";

std::unique_ptr<Window> with(std::string_view scene, int width = 1280, int height = 720) {
    auto window = std::make_unique<Window>(width, height);
    window->viewer.set_recording(test::record_text(scene));
    window->settle();
    return window;
}

} // namespace

TEST_CASE("S goes through the side panels and Ctrl+D takes them away", "[app]") {
    const auto window = with(near_and_far);
    const float beside = window->viewer.layout().screen.width;
    std::vector<SidePanel> seen;
    for (int i = 0; i < viewer::side_panel_count; ++i) {
        seen.push_back(window->state().side);
        window->key(Key::s);
    }
    CHECK(
        seen ==
        std::vector{
            SidePanel::space,
            SidePanel::beside,
            SidePanel::projection,
            SidePanel::precision,
            SidePanel::clipping,
            SidePanel::cost,
            SidePanel::registers,
            SidePanel::normals,
            SidePanel::order,
            SidePanel::search}
    );
    CHECK(window->state().side == SidePanel::space);
    window->key(Key::d, true);
    CHECK(window->viewer.layout().screen.width > beside);
}

TEST_CASE("no side panel cuts its text, at any size, theme and camera", "[app]") {
    for (const auto& [width, height, type] :
         {std::tuple{1280, 720, 1.0F},
          std::tuple{1920, 1080, 1.0F},
          std::tuple{1280, 720, 1.5F},
          std::tuple{1920, 1080, 1.5F}}) {
        for (const std::string_view scene : {near_and_far, test::two_layers}) {
            const auto window = with(scene, width, height);
            window->viewer.state().presentation = type;
            for (const char* const step :
                 {"start",
                  "vertex stage / object 0 / vertex 1",
                  "object 0 / triangle 0 / outcodes"}) {
                REQUIRE_FALSE(window->viewer.go_to(step));
                for (int i = 0; i < viewer::side_panel_count; ++i) {
                    window->viewer.state().side = static_cast<SidePanel>(i);
                    REQUIRE_FALSE(window->viewer.beside().ask({"clip.enabled", "false"}));
                    window->settle();
                    INFO(
                        width << " × " << height << " × " << type << " at " << step << " in " << i
                    );
                    for (const host::CutGlyph& cut : window->host.cut_text()) {
                        FAIL_CHECK("cut at " << cut.x << ", " << cut.y);
                    }
                }
            }
        }
    }
}

TEST_CASE("another near plane records the frame anew and ends the fighting", "[app]") {
    const auto window = with(near_and_far);
    window->viewer.state().side = SidePanel::precision;
    window->settle();
    CHECK(window->viewer.document().fighting_pixels().size() > 100);
    scene::Camera camera = window->viewer.document().scene().camera;
    camera.projection.near = 50.0F;
    camera.projection.far = 101.0F;
    window->viewer.change_camera(camera);
    window->settle();
    CHECK(window->viewer.document().scene().camera.projection.near == 50.0F);
    CHECK(window->viewer.document().fighting_pixels().size() < 10);
}

TEST_CASE("dragging a plane's slider shows at once and records when let go", "[app]") {
    const auto window = with(near_and_far, 1920, 1080);
    window->viewer.state().side = SidePanel::precision;
    window->settle();
    const trace::Recording* before = &window->viewer.document().recording();
    const viewer::Rect side = window->viewer.layout().side;
    const ImVec2 far_slider{side.x + side.width * 0.5F, side.y + 113.0F};
    window->host.move_mouse(far_slider.x, far_slider.y);
    window->host.press(host::MouseButton::left);
    window->settle();
    REQUIRE(window->state().planes.has_value());
    CHECK(&window->viewer.document().recording() == before);
    window->host.release(host::MouseButton::left);
    window->settle();
    CHECK_FALSE(window->state().planes.has_value());
    CHECK(&window->viewer.document().recording() != before);
}

TEST_CASE("a lesson's hidden numbers stay hidden in the side panels", "[app]") {
    Window window;
    window.viewer.open(test::source_dir() / "lessons" / "01-one-triangle");
    window.settle();
    lesson::Session& session = *window.viewer.session();
    while (session.hidden().empty()) {
        window.key(Key::page_down);
    }
    window.viewer.state().side = SidePanel::projection;
    window.settle();
    const host::Picture hidden = window.host.picture();
    session.give_up();
    window.settle();
    const viewer::Rect side = window.viewer.layout().side;
    const host::Picture shown = window.host.picture();
    int changed = 0;
    for (int y = static_cast<int>(side.y); y < static_cast<int>(side.bottom()); ++y) {
        for (int x = static_cast<int>(side.x); x < static_cast<int>(side.right()); ++x) {
            changed += hidden.at(x, y) != shown.at(x, y) ? 1 : 0;
        }
    }
    CHECK(changed > 2000);
}

TEST_CASE(
    "the cost panel compares all traversals, and another one covers the same pixels", "[app]"
) {
    const auto window = with(test::two_layers);
    window->viewer.state().side = SidePanel::cost;
    REQUIRE_FALSE(window->viewer.go_to("object 0 / triangle 0 / outcodes"));
    window->settle();
    const auto costs = window->viewer.document().traversal_costs();
    REQUIRE(costs.size() == names<scene::TraversalKind>().size());
    for (const trace::TraversalCost& cost : costs) {
        INFO(name_of(cost.traversal));
        CHECK(cost.fragments == costs.front().fragments);
        CHECK(cost.cost.pixels >= cost.fragments);
    }
    const std::uint64_t picture = window->viewer.document().recording().digest();
    scene::Settings settings = window->viewer.document().recording().settings();
    settings.traversal = scene::TraversalKind::hierarchical;
    REQUIRE_FALSE(window->viewer.change_settings(settings));
    window->settle();
    CHECK(window->viewer.document().recording().digest() == picture);
    CHECK(window->viewer.document().recording().counters.traversal.tiles > 0);
}

TEST_CASE("the cost panel holds all visible-surface algorithms against each other", "[app]") {
    const auto window = Window::with_scene(1280, 720);
    window->viewer.state().side = SidePanel::cost;
    window->viewer.state().show_side = true;
    window->settle();
    CHECK(window->viewer.document().visibility_outcomes().empty());
    window->viewer.document().compare_visibility();
    window->settle();
    CHECK(window->host.cut_text().empty());
    const auto& outcomes = window->viewer.document().visibility_outcomes();
    REQUIRE(outcomes.size() == names<scene::Visibility>().size());
    for (const trace::VisibilityOutcome& outcome : outcomes) {
        INFO(name_of(outcome.visibility));
        CHECK(outcome.refusal.empty());
        // Only file order, which happens to be back to front, is right by chance
        CHECK(outcome.from_z_buffer.pixels == 0);
    }
}
