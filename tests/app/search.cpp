// Searching in the window: the field, the list, the keys, the marks.
#include "app/viewer/search.hpp"

#include "tests/app/window.hpp"
#include "tests/support/catch.hpp"

using namespace hs;
using test::Window;
using viewer::Key;
using viewer::SidePanel;

namespace {

/// As one types it: Ctrl+F, the text, Enter.
void search_for(Window& window, std::string_view expression) {
    window.key(Key::f, true);
    window.settle();
    window.host.text(expression);
    window.settle();
    window.key(Key::enter);
    window.settle();
}

/// A window whose near layer is drawn first, so that the upper half of the far one fails.
std::unique_ptr<Window> with_failures(int width = 1280, int height = 720) {
    auto window = std::make_unique<Window>(width, height);
    std::string scene{test::two_layers};
    const std::size_t depth = scene.find("[settings]\n") + std::string_view{"[settings]\n"}.size();
    scene.insert(depth, "depth.test = \"greater\"\ndepth.clear = 0\n");
    window->viewer.set_recording(test::record_text(scene));
    window->settle();
    return window;
}

} // namespace

TEST_CASE("what is typed is found, and the keys go from match to match", "[app]") {
    const auto window = with_failures();
    search_for(*window, "fragment.fate == 'depth failed'");
    CHECK(window->state().side == SidePanel::search);
    viewer::Search& search = window->viewer.search();
    REQUIRE(search.is_of(window->viewer.document()));
    CHECK_FALSE(search.running());
    CHECK(search.count() == 128); // the near layer covers half of 16 × 16 pixels
    CHECK(search.size() == 256 + 128);
    CHECK(search.pixels().size() == 128);
    CHECK_FALSE(search.marks().empty());

    window->key(Key::escape); // the field gives the keyboard back
    window->key(Key::home);
    window->settle();
    for (std::size_t i = 0; i < 5; ++i) {
        window->key(Key::f5);
        window->settle();
        CHECK(window->step() == search.address(i).id);
        CHECK_FALSE(window->viewer.document().player().current().passed);
    }
    window->key(Key::f5, false, true);
    window->settle();
    CHECK(window->step() == search.address(3).id);
    window->key(Key::home);
    window->settle();
    CHECK(
        window->viewer.why_not(viewer::Command::previous_match) ==
        "Nothing before this step matches."
    );
}

TEST_CASE("a wrong expression is explained beside the field and loses nothing", "[app]") {
    const auto window = with_failures();
    search_for(*window, "fragment.dept < 1");
    CHECK(
        window->state().search.complaint.find("did you mean \"fragment.depth\"") !=
        std::string::npos
    );
    CHECK_FALSE(window->viewer.search().begun());
    CHECK(window->state().search.text == "fragment.dept < 1");
    CHECK(window->viewer.why_not(viewer::Command::next_match).find("Ctrl+F") != std::string::npos);
}

TEST_CASE("an error while searching ends the search, not the program", "[app]") {
    const auto window = with_failures();
    search_for(*window, "fragment.pixel.x < 3 or fragment.fate < 1");
    CHECK(window->viewer.search().problem().find("attempt to compare") != std::string::npos);
    CHECK_FALSE(window->viewer.search().running());
}

TEST_CASE("the question is asked again about a frame recorded anew", "[app]") {
    const auto window = with_failures();
    search_for(*window, "fragment.fate == 'depth failed'");
    scene::Settings settings = window->viewer.document().recording().settings();
    settings.depth_test_choice = scene::CompareOp::always;
    CHECK_FALSE(window->viewer.change_settings(settings));
    window->viewer.finish_background_work();
    window->settle();
    CHECK(window->viewer.search().is_of(window->viewer.document()));
    CHECK(window->viewer.search().count() == 0);
}
