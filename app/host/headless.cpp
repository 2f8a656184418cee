#include "app/host/headless.hpp"

#include "app/viewer/viewer.hpp"
#include "core/base/check.hpp"

#include <imgui.h>

#include <algorithm>
#include <span>

namespace hs::host {
namespace {

using viewer::Key;

/// Which of our keys ImGui's text fields want.
void map_keys(ImGuiIO& io) {
    const auto map = [&io](ImGuiKey imgui, Key key) { io.KeyMap[imgui] = static_cast<int>(key); };
    map(ImGuiKey_Tab, Key::tab);
    map(ImGuiKey_LeftArrow, Key::left);
    map(ImGuiKey_RightArrow, Key::right);
    map(ImGuiKey_UpArrow, Key::up);
    map(ImGuiKey_DownArrow, Key::down);
    map(ImGuiKey_Home, Key::home);
    map(ImGuiKey_End, Key::end);
    map(ImGuiKey_Delete, Key::del);
    map(ImGuiKey_Backspace, Key::backspace);
    map(ImGuiKey_Enter, Key::enter);
    map(ImGuiKey_Escape, Key::escape);
    map(ImGuiKey_A, Key::a);
    map(ImGuiKey_C, Key::c);
    map(ImGuiKey_V, Key::v);
    map(ImGuiKey_X, Key::x);
    map(ImGuiKey_Y, Key::y);
    map(ImGuiKey_Z, Key::z);
}

} // namespace

// ---- textures

ImTextureID CoreTextures::create(int width, int height) {
    auto texture = std::make_unique<scene::Texture>();
    texture->width = width;
    texture->height = height;
    texture->texels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    textures_.push_back(std::move(texture));
    return textures_.back().get();
}

void CoreTextures::update(
    ImTextureID texture, const PixelRect& rect, std::span<const framebuffer::Rgba8> image
) {
    auto& target = *static_cast<scene::Texture*>(texture);
    for (int y = rect.y0; y < rect.y1; ++y) {
        for (int x = rect.x0; x < rect.x1; ++x) {
            const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(target.width) +
                           static_cast<std::size_t>(x);
            target.texels[i] = framebuffer::unpack(image[i]);
        }
    }
}

void CoreTextures::destroy(ImTextureID texture) {
    std::erase_if(textures_, [texture](const auto& kept) { return kept.get() == texture; });
}

// ---- host

HeadlessHost::HeadlessHost(int width, int height, float scale)
    : width_(width), height_(height), scale_(scale), context_(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.ConfigInputTextCursorBlink = false; // pictures do not depend on when they are taken
    map_keys(io);
}

HeadlessHost::~HeadlessHost() {
    ImGui::DestroyContext(context_);
}

void HeadlessHost::move_mouse(float x, float y) {
    events_.emplace_back(Move{x, y});
}
void HeadlessHost::press(MouseButton button) {
    events_.emplace_back(Button{button, true});
}
void HeadlessHost::release(MouseButton button) {
    events_.emplace_back(Button{button, false});
}
void HeadlessHost::wheel(float notches) {
    events_.emplace_back(Wheel{notches});
}
void HeadlessHost::key(const viewer::KeyPress& press) {
    events_.emplace_back(press);
}
void HeadlessHost::text(std::string_view text) {
    events_.emplace_back(Text{std::string{text}});
}
void HeadlessHost::drop(const std::filesystem::path& file) {
    events_.emplace_back(Drop{file});
}
void HeadlessHost::click(float x, float y, MouseButton button) {
    move_mouse(x, y);
    press(button);
    release(button);
}
void HeadlessHost::resize(int width, int height) {
    width_ = width;
    height_ = height;
}

void HeadlessHost::feed_key(viewer::Viewer& viewer, const viewer::KeyPress& press) {
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = press.ctrl;
    io.KeyShift = press.shift;
    io.KeyAlt = press.alt;
    io.KeysDown[static_cast<int>(press.key)] = true;
    held_ = press.key;
    viewer.key(press);
}

void HeadlessHost::feed_events(viewer::Viewer& viewer) {
    ImGuiIO& io = ImGui::GetIO();
    io.KeysDown[static_cast<int>(held_)] = false;
    held_ = Key::none;
    io.KeyCtrl = false;
    io.KeyShift = false;
    io.KeyAlt = false;

    // Stop after an event that changes what a later one means
    bool more = true;
    while (more && !events_.empty()) {
        const Event event = std::move(events_.front());
        events_.pop_front();
        more = false;
        if (const Move* move = std::get_if<Move>(&event)) {
            io.MousePos = {move->x, move->y};
        } else if (const Button* button = std::get_if<Button>(&event)) {
            io.MouseDown[static_cast<int>(button->button)] = button->down;
        } else if (const Wheel* wheel = std::get_if<Wheel>(&event)) {
            io.MouseWheel += wheel->notches;
        } else if (const auto* press = std::get_if<viewer::KeyPress>(&event)) {
            feed_key(viewer, *press);
        } else if (const Text* text = std::get_if<Text>(&event)) {
            io.AddInputCharactersUTF8(text->text.c_str());
            viewer.text(text->text);
        } else {
            viewer.open(std::get<Drop>(event).file);
        }
    }
}

void HeadlessHost::upload_fonts() {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    unsigned char* alpha = nullptr;
    int width = 0;
    int height = 0;
    atlas.GetTexDataAsAlpha8(&alpha, &width, &height);
    if (font_texture_ != nullptr) {
        textures_.destroy(font_texture_);
    }
    font_texture_ = textures_.create(width, height);
    const std::span<const unsigned char> source{
        alpha, static_cast<std::size_t>(width) * static_cast<std::size_t>(height)};
    std::vector<framebuffer::Rgba8> image(source.size());
    std::ranges::transform(source, image.begin(), [](unsigned char a) {
        return 0x00FFFFFFU | static_cast<framebuffer::Rgba8>(a) << 24U;
    });
    textures_.update(font_texture_, {0, 0, width, height}, image);
    atlas.SetTexID(font_texture_);
}

void HeadlessHost::frame(viewer::Viewer& viewer, float seconds) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width_), static_cast<float>(height_)};
    io.DeltaTime = seconds;
    if (viewer.prepare_fonts(scale_)) {
        upload_fonts();
    }
    feed_events(viewer);
    ImGui::NewFrame();
    viewer.draw(io.DisplaySize, textures_);
    ImGui::Render();
}

void HeadlessHost::settle(viewer::Viewer& viewer) {
    constexpr int frames_to_settle = 3; // ImGui sizes windows from their last frame's content
    for (int quiet = 0; quiet < frames_to_settle; ++quiet) {
        if (!events_.empty() || viewer.moving()) {
            quiet = 0;
        }
        frame(viewer);
        if (viewer.busy()) {
            quiet = -1; // what it brings is yet to be laid out
        }
        viewer.finish_background_work();
    }
}

Picture HeadlessHost::picture() const {
    ImGui::SetCurrentContext(context_);
    const ImDrawData* data = ImGui::GetDrawData();
    HS_CHECK(data != nullptr, "a frame was laid out before its picture is asked for");
    scene::Settings settings;
    settings.width = width_;
    settings.height = height_;
    framebuffer::Framebuffer framebuffer{settings};
    draw(*data, framebuffer);
    return {width_, height_, framebuffer.rgba8()};
}

std::vector<CutGlyph> HeadlessHost::cut_text() const {
    ImGui::SetCurrentContext(context_);
    const ImDrawData* data = ImGui::GetDrawData();
    HS_CHECK(data != nullptr, "a frame was laid out before its text is checked");
    return cut_glyphs(*data, font_texture_);
}

} // namespace hs::host
