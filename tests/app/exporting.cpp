// Out of the window into files: what is shown is what is written.
#include "tests/app/window.hpp"
#include "tests/export/temporary_folder.hpp"
#include "tests/support/catch.hpp"

#include <OpenImageIO/imageio.h>

using namespace hs;
using test::Window;
using viewer::Key;

namespace {

/// Types a path over the one that is offered.
void export_to(Window& window, const std::filesystem::path& file) {
    window.key(Key::e, true);
    REQUIRE(window.state().prompt == viewer::Prompt::export_file);
    CHECK_FALSE(window.state().prompt_text.empty());
    window.host.text(file.string());
    window.key(Key::enter);
}

} // namespace

TEST_CASE("Ctrl+E writes the depth of this step to an EXR that reads back equal", "[app]") {
    const tests::TemporaryFolder folder;
    const auto window = Window::with_scene();
    REQUIRE_FALSE(window->viewer.go_to("object 1 / triangle 1 / fragment 3,3 / merge"));
    window->viewer.state().screen.content = viewer::ScreenContent::depth;
    const std::filesystem::path file = folder / "depth.exr";
    export_to(*window, file);
    CHECK(window->state().prompt == viewer::Prompt::none);
    CHECK(window->state().problems.empty());
    CHECK(window->state().notice.find("depth.exr") != std::string::npos);

    const auto input = OIIO::ImageInput::open(file.string());
    REQUIRE(input);
    REQUIRE(input->spec().width == 16);
    REQUIRE(input->spec().nchannels == 1);
    std::vector<float> depth(256);
    REQUIRE(input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, depth.data()));
    const trace::Player& player = window->viewer.document().player();
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            CHECK(depth[static_cast<std::size_t>(y * 16 + x)] == player.pixel({x, y}).depth);
        }
    }
}

TEST_CASE("an export that cannot be written says why and stays open", "[app]") {
    const auto window = Window::with_scene();
    for (const char* const file : {"/no/such/folder/depth.exr", "depth.jpeg"}) {
        export_to(*window, file);
        CHECK(window->state().prompt == viewer::Prompt::export_file);
        CHECK_FALSE(window->state().prompt_error.empty());
        window->key(Key::escape);
    }
}
