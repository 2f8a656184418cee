// Files in: dropped, typed, wrong; and settings that record the frame anew.
#include "app/lesson/session.hpp"
#include "app/viewer/lesson_hiding.hpp"
#include "tests/app/window.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <filesystem>
#include <fstream>

using namespace hs;
using test::Window;
using viewer::Key;

namespace {

/// A file that is gone after the test.
class File {
public:
    File(const std::string& name, std::string_view content)
        : path(std::filesystem::temp_directory_path() / ("halfspace-test-" + name)) {
        std::ofstream{path} << content;
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    File(File&&) = delete;
    File& operator=(File&&) = delete;
    ~File() {
        std::error_code error;
        std::filesystem::remove(path, error);
    }
    std::filesystem::path path;
};

} // namespace

TEST_CASE("a dropped scene is opened and remembered", "[app]") {
    const File file{"drop.toml", test::two_layers};
    Window window;
    REQUIRE_FALSE(window.viewer.document().is_open());
    window.host.drop(file.path);
    window.settle();
    REQUIRE(window.viewer.document().is_open());
    CHECK(window.viewer.document().scene().name == "two layers");
    CHECK(window.state().recent == std::vector{file.path});
    CHECK(window.step() == window.viewer.document().player().end());
}

TEST_CASE("Ctrl+O opens the path typed into its field", "[app]") {
    const File file{"typed.toml", test::two_layers};
    Window window;
    window.key(Key::o, true);
    window.host.text(file.path.string());
    window.key(Key::enter);
    CHECK(window.viewer.document().is_open());
    CHECK(window.state().prompt == viewer::Prompt::none);
}

TEST_CASE("a scene opens at the step asked for", "[app]") {
    const File file{"at.toml", test::two_layers};
    Window window;
    window.viewer.open(file.path, {.at = "object 1 / triangle 0 / outcodes", .assignments = {}});
    window.settle();
    CHECK(window.viewer.document().player().current().kind == trace::StepKind::outcodes);
}

TEST_CASE("what is wrong with a file is listed and what was open stays", "[app]") {
    const File file{"wrong.toml", "[settings]\nsize = [0, 0]\nshadng = 'flat'\n"};
    const auto window = Window::with_scene();
    window->host.drop(file.path);
    window->settle();
    CHECK_FALSE(window->state().problems.empty());
    CHECK(window->viewer.document().scene().name == "two layers");
    window->key(Key::escape);
    CHECK(window->state().problems.empty());
}

TEST_CASE("a changed setting records the frame anew and keeps the step", "[app]") {
    const auto window = Window::with_scene();
    REQUIRE_FALSE(window->viewer.go_to("object 1 / triangle 1 / fragment 3,3 / depth test"));
    const trace::Step before = window->viewer.document().player().current();
    scene::Settings settings = window->viewer.document().scene().settings;
    settings.depth_test_choice = scene::CompareOp::greater;
    REQUIRE_FALSE(window->viewer.change_settings(settings));
    window->settle();
    const trace::Step after = window->viewer.document().player().current();
    CHECK(after.kind == trace::StepKind::depth_test);
    CHECK(after.object == before.object);
    CHECK(after.triangle == before.triangle);
    CHECK(after.pixel == before.pixel);
    CHECK_FALSE(after.passed);
}

TEST_CASE("settings without meaning are refused in a sentence", "[app]") {
    const auto window = Window::with_scene();
    scene::Settings settings = window->viewer.document().scene().settings;
    settings.viewport_choice = PixelRect{0, 0, 99, 99};
    CHECK(window->viewer.change_settings(settings).has_value());
}

TEST_CASE("a lesson's hidden numbers stay hidden until its question is answered", "[app]") {
    Window window;
    window.viewer.open(test::source_dir() / "lessons" / "01-one-triangle");
    window.settle();
    lesson::Session* session = window.viewer.session();
    REQUIRE(session != nullptr);
    std::size_t step = 0;
    while (step < session->lesson().steps.size() && !viewer::hides_space(window.viewer, "ndc")) {
        window.viewer.go_to_lesson_step(step++);
    }
    REQUIRE(viewer::hides_space(window.viewer, "ndc"));
    CHECK(viewer::hides_space(window.viewer, "window"));
    CHECK(session->state() == lesson::QuestionState::open);
    window.settle();
    CHECK(window.host.cut_text().empty());
    session->give_up();
    CHECK_FALSE(viewer::hides_numbers(window.viewer));
}
