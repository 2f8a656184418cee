// The screen view: picking, zooming, and pixels shown as they are.
#include "app/viewer/screen_overlay.hpp"
#include "app/viewer/screen_picture.hpp"
#include "tests/app/window.hpp"
#include "tests/support/catch.hpp"

#include <cmath>

using namespace hs;
using test::Window;
using viewer::Key;
using viewer::ScreenContent;

namespace {

/// Takes pictures and shows them to nobody.
class NoTextures : public viewer::Textures {
public:
    ImTextureID create(int, int) override { return this; }
    void update(ImTextureID, const PixelRect&, std::span<const framebuffer::Rgba8>) override {}
    void destroy(ImTextureID) override {}
};

framebuffer::Rgba8 shown_at(const Window& window, PixelPos pixel) {
    const ImVec2 at = window.viewer.screen_position(pixel);
    // Beside the center, where sample points and marks are not
    const float off = window.state().screen.zoom * 0.3F;
    return window.host.picture().at(static_cast<int>(at.x + off), static_cast<int>(at.y + off));
}

} // namespace

TEST_CASE("a click picks the pixel under the mouse", "[app]") {
    const auto window = Window::with_scene();
    for (const PixelPos pixel : {PixelPos{0, 0}, PixelPos{15, 0}, PixelPos{3, 12}}) {
        window->click(window->viewer.screen_position(pixel));
        CHECK(window->state().selected == pixel);
    }
    window->click(window->viewer.screen_position({7, 8}), host::MouseButton::right);
    CHECK(window->state().selected == PixelPos{7, 8});
}

TEST_CASE("Alt and arrows nudge the picked pixel and stop at the image's edge", "[app]") {
    const auto window = Window::with_scene();
    window->click(window->viewer.screen_position({1, 0}));
    window->key(Key::left, false, false, true);
    CHECK(window->state().selected == PixelPos{0, 0});
    window->key(Key::left, false, false, true);
    window->key(Key::up, false, false, true);
    CHECK(window->state().selected == PixelPos{0, 0});
    window->key(Key::down, false, false, true);
    CHECK(window->state().selected == PixelPos{0, 1});
}

TEST_CASE("the wheel zooms around the mouse", "[app]") {
    const auto window = Window::with_scene();
    const PixelPos pixel{4, 11};
    const ImVec2 at = window->viewer.screen_position(pixel);
    const float before = window->state().screen.zoom;
    window->host.move_mouse(at.x, at.y);
    window->host.wheel(3.0F);
    window->settle();
    CHECK(window->state().screen.zoom > before);
    const ImVec2 after = window->viewer.screen_position(pixel);
    CHECK(std::fabs(after.x - at.x) <= 1.5F);
    CHECK(std::fabs(after.y - at.y) <= 1.5F);
}

TEST_CASE("a drag pans and does not pick", "[app]") {
    const auto window = Window::with_scene();
    const ImVec2 at = window->viewer.screen_position({8, 8});
    window->host.move_mouse(at.x, at.y);
    window->host.press(host::MouseButton::left);
    window->host.move_mouse(at.x + 40.0F, at.y + 20.0F);
    window->host.release(host::MouseButton::left);
    window->settle();
    CHECK_FALSE(window->state().selected.has_value());
    const ImVec2 after = window->viewer.screen_position({8, 8});
    CHECK(std::fabs(after.x - at.x - 40.0F) <= 1.5F);
    CHECK(std::fabs(after.y - at.y - 20.0F) <= 1.5F);
}

TEST_CASE("the picture shows the colors of the framebuffer after the step", "[app]") {
    const auto window = Window::with_scene();
    window->viewer.state().screen.show_outline = false;
    window->viewer.state().screen.show_numbers = false;
    window->settle();
    const framebuffer::Rgba8 blue = framebuffer::pack({0.0F, 0.0F, 1.0F, 1.0F});
    const framebuffer::Rgba8 red = framebuffer::pack({1.0F, 0.0F, 0.0F, 1.0F});
    CHECK(shown_at(*window, {8, 3}) == blue);
    CHECK(shown_at(*window, {8, 12}) == red);

    window->key(Key::home);
    CHECK(shown_at(*window, {8, 3}) == framebuffer::pack({0.0F, 0.0F, 0.0F, 1.0F}));
}

TEST_CASE("stepping back repaints what stepping forward painted", "[app]") {
    const auto window = Window::with_scene();
    window->viewer.seek(40);
    window->settle();
    const host::Picture before = window->host.picture();
    window->key(Key::end);
    window->viewer.seek(40);
    window->settle();
    CHECK(window->host.picture().pixels == before.pixels);
}

TEST_CASE("only what is in sight is painted, and no finer than the window shows it", "[app]") {
    constexpr std::string_view large = R"(
[settings]
size = [1920, 1080]
[camera]
projection = { kind = "identity" }
[[object]]
name = "quad"
vertices = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]
polygons = [[0, 1, 2, 3]]
)";
    const auto window = Window::with_scene();
    window->viewer.set_recording(test::record_text(large));
    window->viewer.state().screen.fitted = true;
    window->settle();
    NoTextures textures;
    viewer::ScreenPicture picture;
    viewer::Document& document = window->viewer.document();
    viewer::ScreenView view = window->state().screen;
    const PixelRect image = document.recording().settings().image();
    const auto update = [&] {
        const PixelRect visible = viewer::visible_pixels(view, image);
        picture.update(document, view, visible, window->viewer.theme(), textures);
    };
    const float window_pixels = view.area.width * view.area.height;
    update();
    CHECK(picture.block() > 1);
    CHECK(static_cast<float>(picture.painted()) < 2.5F * window_pixels);

    // From one end of the frame to the other: as much again, and nothing without a change
    document.player().seek(0);
    update();
    CHECK(static_cast<float>(picture.painted()) < 2.5F * window_pixels);
    CHECK(picture.painted() > 0);
    update();
    CHECK(picture.painted() == 0);

    // Close up, a pixel is a texel; the rest of the image stays as it was until it is panned to
    view.zoom = 8.0F;
    document.player().seek(document.player().end());
    update();
    CHECK(picture.block() == 1);
    CHECK(static_cast<float>(picture.painted()) < 2.5F * window_pixels);
    CHECK(picture.painted() < 200000);
    view.center = {300.0F, 200.0F};
    update();
    CHECK(picture.painted() > 0);
    for (const PixelPos pixel : {PixelPos{300, 200}, PixelPos{310, 190}}) {
        CHECK(picture.shown(pixel) == (document.player().pixel(pixel).color | 0xFF000000U));
    }
}

TEST_CASE("edge and weight colors say on which side a pixel lies", "[app]") {
    const auto window = Window::with_scene();
    REQUIRE_FALSE(window->viewer.go_to("object 0 / triangle 0 / setup"));
    const trace::PieceDetail* piece = window->viewer.document().piece_detail();
    REQUIRE((piece != nullptr && piece->setup));
    const raster::TriangleSetup& setup = *piece->setup;
    for (unsigned k = 0; k < 3; ++k) {
        const viewer::EdgeColors colors{setup.edges[k], 16.0F * 16.0F * 65536.0F};
        for (int y = 0; y < 16; ++y) {
            for (int x = 0; x < 16; ++x) {
                const framebuffer::Rgba8 color = colors({x, y});
                const bool bluish = (color >> 16U & 0xFFU) > (color & 0xFFU);
                CHECK(bluish == (setup.edges[k]({x, y}) >= 0));
            }
        }
    }
    const viewer::WeightColors weights{setup, window->viewer.theme()};
    const auto light = [](framebuffer::Rgba8 c) {
        return (c & 0xFFU) + (c >> 8U & 0xFFU) + (c >> 16U & 0xFFU);
    };
    CHECK(light(weights({0, 15})) + light(weights({15, 15})) > 2 * light(weights({0, 0})));
}

TEST_CASE("every view prints the exact number of a pixel", "[app]") {
    const auto window = Window::with_scene();
    viewer::Document& document = window->viewer.document();
    const auto number = [&](ScreenContent content, PixelPos pixel) {
        const auto lines = viewer::pixel_numbers(document, content, pixel);
        return lines.empty() ? std::string{} : lines.front();
    };
    CHECK(number(ScreenContent::depth, {8, 3}) == "0.2500");
    CHECK(number(ScreenContent::depth, {8, 12}) == "0.7500");
    CHECK(number(ScreenContent::overdraw, {8, 3}) == "2");
    CHECK(number(ScreenContent::complexity, {8, 12}) == "1");
    CHECK(number(ScreenContent::color, {8, 12}) == "255");
    CHECK(number(ScreenContent::edge0, {8, 12}).empty());
    window->viewer.go_to("object 0 / triangle 0 / pixel 8,12");
    CHECK_FALSE(number(ScreenContent::edge0, {8, 12}).empty());
}

TEST_CASE("numbers appear on pixels that are large enough to hold them", "[app]") {
    const auto window = Window::with_scene();
    viewer::ScreenView& view = window->viewer.state().screen;
    view.fitted = false;
    view.zoom = 64.0F;
    window->settle();
    const host::Picture with = window->host.picture();
    view.show_numbers = false;
    window->settle();
    CHECK(window->host.picture().pixels != with.pixels);
}

TEST_CASE("the history of the picked pixel lists what hid what", "[app]") {
    const auto window = Window::with_scene();
    window->click(window->viewer.screen_position({8, 3}));
    const trace::PixelHistory& history =
        window->viewer.document().history(*window->state().selected);
    REQUIRE(history.rows.size() == 2);
    CHECK(history.rows[1].object == 1);
    CHECK(history.rows[1].fate == fragment::FragmentFate::written);
}
