// Several samples a pixel, as the window shows them.
#include "core/raster/sample_pattern.hpp"
#include "tests/app/window.hpp"
#include "tests/support/catch.hpp"

#include <algorithm>

using namespace hs;
using test::Window;
using viewer::Key;

namespace {

/// Two triangles of one color each; edges run through many pixels.
constexpr std::string_view slanted = R"(
[settings]
size = [8, 8]
samples = 4
[camera]
projection = { kind = "identity" }
[[object]]
vertices = [[-0.9, -0.9, 0], [0.8, -0.6, 0], [-0.3, 0.9, 0]]
polygons = [[0, 1, 2]]
colors = [[1, 0, 0], [1, 0, 0], [1, 0, 0]]
[[object]]
vertices = [[-0.5, -0.2, -0.5], [0.9, -0.3, -0.5], [0.6, 0.8, -0.5]]
polygons = [[0, 1, 2]]
colors = [[0, 0, 1], [0, 0, 1], [0, 0, 1]]
)";

std::unique_ptr<Window> sampled_window() {
    auto window = std::make_unique<Window>();
    window->viewer.set_recording(test::record_text(slanted));
    window->viewer.state().screen.show_outline = false;
    window->viewer.state().screen.show_numbers = false;
    window->settle();
    return window;
}

/// The window's color at a sample of a pixel.
framebuffer::Rgba8 shown_at(const Window& window, PixelPos pixel, const raster::SampleOffset& at) {
    const ImVec2 center = window.viewer.screen_position(pixel);
    const float scale = window.state().screen.zoom / static_cast<float>(subpixel_scale);
    return window.host.picture().at(
        static_cast<int>(center.x + static_cast<float>(at.x) * scale),
        static_cast<int>(center.y + static_cast<float>(at.y) * scale)
    );
}

/// Samples whose place in the window does not show what `expected(pixel, sample)` says.
template <typename Expected>
int wrong_samples(const Window& window, Expected&& expected) {
    int wrong = 0;
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            for (int s = 0; s < 4; ++s) {
                const auto offset = raster::sample_pattern(4)[static_cast<std::size_t>(s)];
                wrong += shown_at(window, {x, y}, offset) ==
                                 framebuffer::pack(expected(PixelPos{x, y}, s))
                             ? 0
                             : 1;
            }
        }
    }
    return wrong;
}

} // namespace

TEST_CASE("every sample shows what it holds until its pixel is resolved", "[app]") {
    const auto window = sampled_window();
    const trace::Recording& recording = window->viewer.document().recording();
    window->viewer.seek(recording.first_resolve_step - 1);
    window->settle();
    const trace::Player& player = window->viewer.document().player();
    CHECK(wrong_samples(*window, [&](PixelPos pixel, int sample) {
              return player.samples(pixel)[sample].color;
          }) == 0);

    window->viewer.seek(recording.end_step);
    window->settle();
    CHECK(wrong_samples(*window, [&](PixelPos pixel, int) { return player.color(pixel); }) == 0);
}

TEST_CASE("helper pixels are shown on request", "[app]") {
    const auto window = sampled_window();
    const trace::Recording& recording = window->viewer.document().recording();
    window->viewer.seek(trace::last_step_of_triangle(recording, 1));
    window->settle();
    const auto before = window->host.picture().pixels;
    CHECK_FALSE(window->viewer.document().helper_pixels().helpers.empty());
    window->key(Key::h);
    CHECK(window->host.picture().pixels != before);
    window->key(Key::h);
    CHECK(window->host.picture().pixels == before);
}
