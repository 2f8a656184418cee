// A viewer without a display: events in, pictures out. Tests and `halfspace shot` use it; the
// pipeline this program teaches draws the program.
#pragma once

#include "app/host/draw_list_raster.hpp"
#include "app/viewer/keys.hpp"
#include "app/viewer/textures.hpp"
#include "core/framebuffer/color.hpp"
#include "core/scene/texture.hpp"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

struct ImGuiContext;

namespace hs::viewer {
class Viewer;
}

namespace hs::host {

struct Picture {
    int width = 0;
    int height = 0;
    std::vector<framebuffer::Rgba8> pixels; ///< row 0 at the top

    [[nodiscard]] framebuffer::Rgba8 at(int x, int y) const {
        return pixels
            [static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
             static_cast<std::size_t>(x)];
    }
};

enum class MouseButton : std::uint8_t {
    left,
    right,
    middle
};

/// Textures kept as the core's, where the pipeline reads them.
class CoreTextures : public viewer::Textures {
public:
    ImTextureID create(int width, int height) override;
    void update(
        ImTextureID texture, const PixelRect& rect, std::span<const framebuffer::Rgba8> image
    ) override;
    void destroy(ImTextureID texture) override;

private:
    std::vector<std::unique_ptr<scene::Texture>> textures_;
};

class HeadlessHost {
public:
    HeadlessHost(int width, int height, float scale = 1.0F);
    HeadlessHost(const HeadlessHost&) = delete;
    HeadlessHost& operator=(const HeadlessHost&) = delete;
    HeadlessHost(HeadlessHost&&) = delete;
    HeadlessHost& operator=(HeadlessHost&&) = delete;
    ~HeadlessHost();

    // Events wait in a queue; each frame takes them up to the first that another frame must see.
    void move_mouse(float x, float y);
    void press(MouseButton button);
    void release(MouseButton button);
    void wheel(float notches);
    void key(const viewer::KeyPress& press);
    void text(std::string_view text);
    void drop(const std::filesystem::path& file);
    /// Move, press, release.
    void click(float x, float y, MouseButton button = MouseButton::left);
    void resize(int width, int height);

    /// Feeds events and lays out one frame; draws nothing yet.
    void frame(viewer::Viewer& viewer, float seconds = 1.0F / 60.0F);
    /// Frames until the queue is empty and the layout has settled. Waits for background work.
    void settle(viewer::Viewer& viewer);

    /// The last frame, drawn by the core.
    [[nodiscard]] Picture picture() const;
    /// Text of the last frame that its clip rectangle cuts.
    [[nodiscard]] std::vector<CutGlyph> cut_text() const;

private:
    struct Move {
        float x, y;
    };
    struct Button {
        MouseButton button;
        bool down;
    };
    struct Wheel {
        float notches;
    };
    struct Text {
        std::string text;
    };
    struct Drop {
        std::filesystem::path file;
    };
    using Event = std::variant<Move, Button, Wheel, viewer::KeyPress, Text, Drop>;

    void feed_events(viewer::Viewer& viewer);
    void feed_key(viewer::Viewer& viewer, const viewer::KeyPress& press);
    void upload_fonts();

    int width_;
    int height_;
    float scale_;
    ImGuiContext* context_;
    CoreTextures textures_;
    ImTextureID font_texture_ = nullptr;
    std::deque<Event> events_;
    viewer::Key held_ = viewer::Key::none; ///< down for one frame, so that text fields see it
};

} // namespace hs::host
