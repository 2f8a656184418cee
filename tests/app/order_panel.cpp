// The order panel: every algorithm's state at every decision, with no text cut.
#include "core/scene/scene_file.hpp"
#include "tests/app/window.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

using namespace hs;
using test::Window;
using viewer::SidePanel;

namespace {

std::shared_ptr<const trace::Recording> cycle_ordered_by(scene::Visibility visibility) {
    auto scene = scene::load_scene(test::source_dir() / "lessons/scenes/three-triangle-cycle.toml");
    REQUIRE(scene);
    scene->settings.visibility = visibility;
    const auto recording = trace::record(std::make_shared<const scene::Scene>(*scene));
    REQUIRE(recording);
    return *recording;
}

} // namespace

TEST_CASE("the order panel shows every decision of every algorithm", "[app]") {
    for (const Named<scene::Visibility>& kind : names<scene::Visibility>()) {
        Window window(1280, 720);
        window.viewer.set_recording(cycle_ordered_by(kind.value));
        while (window.state().side != SidePanel::order) {
            window.key(viewer::Key::s);
        }
        const trace::Recording& recording = window.viewer.document().recording();
        const trace::StepId last = std::min(recording.end_step, recording.first_triangle_step + 4);
        for (trace::StepId id = recording.first_order_step - 1; id <= last; ++id) {
            window.viewer.seek(id);
            window.settle();
            INFO(kind.name << ", step " << id);
            CHECK(window.host.cut_text().empty());
        }
    }
}

TEST_CASE("the order panel shows every row of scanlines and rays", "[app]") {
    for (const auto visibility :
         {scene::Visibility::scanline,
          scene::Visibility::scanline_z,
          scene::Visibility::ray_cast}) {
        Window window(1280, 720);
        window.viewer.set_recording(cycle_ordered_by(visibility));
        while (window.state().side != SidePanel::order) {
            window.key(viewer::Key::s);
        }
        const trace::Recording& recording = window.viewer.document().recording();
        const trace::StepId stride = (recording.end_step - recording.first_sweep_step) / 40 + 1;
        for (trace::StepId id = recording.first_sweep_step; id < recording.end_step; id += stride) {
            window.viewer.seek(id);
            window.settle();
            INFO(name_of(visibility) << ", step " << id);
            CHECK(window.host.cut_text().empty());
        }
    }
}

TEST_CASE("a click on the strip's visibility stage goes to the first decision", "[app]") {
    Window window(1280, 720);
    window.viewer.set_recording(cycle_ordered_by(scene::Visibility::painters));
    window.key(viewer::Key::home);
    const viewer::Rect strip = window.viewer.layout().strip;
    const scene::Settings& settings = window.viewer.document().recording().settings();
    const float width = strip.width / static_cast<float>(viewer::strip_stages(settings).size());
    window.click({width * 2.5F, strip.y + strip.height * 0.5F}); // application, vertex, visibility
    CHECK(window.step() == window.viewer.document().recording().first_order_step);
}
