// The screen view's picture: one texture, repainted only where the playhead changed pixels.
#pragma once

#include "app/viewer/document.hpp"
#include "app/viewer/state.hpp"
#include "app/viewer/textures.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hs::viewer {

/// What values a view's colors span.
struct ValueRange {
    float low = 0.0F;
    float high = 1.0F;
};

class ScreenPicture {
public:
    /// Brings the texture up to date with the playhead. Precondition: a document is open.
    void update(Document& document, ScreenContent content, const Theme& theme, Textures& textures);

    [[nodiscard]] ImTextureID texture() const { return texture_; }
    /// Image pixels per texel: more than 1 only for triangle views of large images.
    [[nodiscard]] int block() const { return block_; }
    [[nodiscard]] ValueRange range() const { return range_; }
    /// The color a pixel is shown in; for text on top of it.
    [[nodiscard]] framebuffer::Rgba8 shown(PixelPos pixel) const;

private:
    /// What the texture shows; when it differs, everything is repainted.
    struct Subject {
        unsigned document = 0;
        ScreenContent content = ScreenContent::color;
        ThemeKind theme = ThemeKind::dark;
        std::optional<std::uint32_t> triangle; ///< of triangle views
        std::int32_t piece = 0;
        friend bool operator==(const Subject&, const Subject&) = default;
    };

    void resize(const Document& document, ScreenContent content, Textures& textures);
    void measure(const Document& document, ScreenContent content);
    void paint(const Document& document, const PixelRect& texels, const Theme& theme);

    ImTextureID texture_ = nullptr;
    int width_ = 0; ///< of the texture
    int height_ = 0;
    int block_ = 1;
    std::vector<framebuffer::Rgba8> image_;
    std::optional<Subject> subject_;
    ValueRange range_;
};

/// Text colors for a ground: black or white, whichever is easier to read.
ImU32 ink_on(framebuffer::Rgba8 ground);

/// The color of a count from 0 (dark) to `most` (bright), even in lightness.
framebuffer::Rgba8 count_color(std::uint32_t count, std::uint32_t most);

/// The numbers a pixel shows when it is large enough, one line each; also what a legend reads out.
std::vector<std::string> pixel_numbers(Document& document, ScreenContent content, PixelPos pixel);

} // namespace hs::viewer
