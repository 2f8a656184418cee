#include "tests/app/window.hpp"

#include "core/scene/scene_file.hpp"
#include "tests/support/catch.hpp"

namespace hs::test {

std::shared_ptr<const trace::Recording> record_text(std::string_view toml) {
    const Result<scene::Scene> scene = scene::parse_scene(toml, "test.toml");
    REQUIRE(scene);
    const auto recording = trace::record(std::make_shared<const scene::Scene>(*scene));
    REQUIRE(recording);
    return *recording;
}

Window::Window(int width, int height) : host(width, height) {
    settle();
}

std::unique_ptr<Window> Window::with_scene(int width, int height) {
    auto window = std::make_unique<Window>(width, height);
    window->viewer.set_recording(record_text(two_layers));
    window->settle();
    return window;
}

void Window::key(viewer::Key key, bool ctrl, bool shift, bool alt) {
    host.key({.key = key, .ctrl = ctrl, .shift = shift, .alt = alt});
    settle();
}

void Window::click(ImVec2 at, host::MouseButton button) {
    host.click(at.x, at.y, button);
    settle();
}

} // namespace hs::test
