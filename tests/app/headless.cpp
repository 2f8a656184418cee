// ImGui's draw lists through our own pipeline.
#include "app/host/draw_list_raster.hpp"
#include "tests/app/window.hpp"
#include "tests/support/catch.hpp"

using namespace hs;

namespace {

/// What `draw` adds to an otherwise empty 32 × 32 display.
template <typename Draw>
framebuffer::Framebuffer drawn(Draw&& draw) {
    ImGuiContext* context = ImGui::CreateContext();
    ImGui::SetCurrentContext(context);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {32.0F, 32.0F};
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    scene::Texture white;
    white.texels.assign(1, glm::vec4{1.0F});
    io.Fonts->Build();
    io.Fonts->SetTexID(&white);
    ImGui::NewFrame();
    draw(*ImGui::GetForegroundDrawList());
    ImGui::Render();
    scene::Settings settings;
    settings.width = 32;
    settings.height = 32;
    framebuffer::Framebuffer framebuffer{settings};
    host::draw(*ImGui::GetDrawData(), framebuffer);
    ImGui::DestroyContext(context);
    return framebuffer;
}

constexpr ImU32 red = IM_COL32(255, 0, 0, 255);

} // namespace

TEST_CASE("a filled rectangle covers exactly its pixels", "[app]") {
    const auto picture = drawn([](ImDrawList& list) {
        list.AddRectFilled({4.0F, 5.0F}, {10.0F, 9.0F}, red);
    });
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {
            const bool inside = x >= 4 && x < 10 && y >= 5 && y < 9;
            CHECK((picture.color({x, y}).r == 1.0F) == inside);
        }
    }
}

TEST_CASE("nothing is drawn outside a clip rectangle", "[app]") {
    const auto picture = drawn([](ImDrawList& list) {
        list.PushClipRect({8.0F, 8.0F}, {12.0F, 16.0F});
        list.AddRectFilled({-100.0F, -100.0F}, {100.0F, 100.0F}, red);
        list.PopClipRect();
    });
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {
            const bool inside = x >= 8 && x < 12 && y >= 8 && y < 16;
            CHECK((picture.color({x, y}).r == 1.0F) == inside);
        }
    }
}

TEST_CASE("half transparent shapes are blended over what is there", "[app]") {
    const auto picture = drawn([](ImDrawList& list) {
        list.AddRectFilled({0.0F, 0.0F}, {32.0F, 32.0F}, red);
        list.AddRectFilled({0.0F, 0.0F}, {32.0F, 32.0F}, IM_COL32(0, 0, 255, 128));
    });
    const glm::vec4 color = picture.color({16, 16});
    CHECK(color.r == Approx(127.0 / 255.0).margin(0.005));
    CHECK(color.b == Approx(128.0 / 255.0).margin(0.005));
}

TEST_CASE("draw lists beyond 65536 vertices keep every shape", "[app]") {
    const auto picture = drawn([](ImDrawList& list) {
        for (int i = 0; i < 20000; ++i) {
            list.AddRectFilled({0.0F, 0.0F}, {1.0F, 1.0F}, red);
        }
        list.AddRectFilled({20.0F, 20.0F}, {21.0F, 21.0F}, red);
    });
    CHECK(picture.color({20, 20}).r == 1.0F);
}

TEST_CASE("two windows that saw the same events show the same picture", "[app]") {
    const auto a = test::Window::with_scene(640, 480);
    const auto b = test::Window::with_scene(640, 480);
    for (test::Window* window : {a.get(), b.get()}) {
        window->key(viewer::Key::home);
        window->key(viewer::Key::right);
        window->click(window->viewer.screen_position({3, 3}));
    }
    CHECK(a->host.picture().pixels == b->host.picture().pixels);
}
