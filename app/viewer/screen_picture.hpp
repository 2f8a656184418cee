// The screen view's picture: one texture, repainted only where the playhead changed pixels that are
// in sight.
//
// It is as fine as the window can show, not as the image is: where a window pixel holds many image
// pixels, one texel stands for a block of them. Where the texture no longer shows what the
// framebuffer holds is kept by tile; tiles out of sight stay behind until they come into it.
#pragma once

#include "app/viewer/document.hpp"
#include "app/viewer/screen_colors.hpp"
#include "app/viewer/state.hpp"
#include "app/viewer/textures.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hs::viewer {

class ScreenPicture {
public:
    /// Brings the texture up to date with the playhead where `visible` pixels need it.
    /// Precondition: a document is open.
    void update(
        Document& document,
        const ScreenView& view,
        const PixelRect& visible,
        const Theme& theme,
        Textures& textures
    );

    [[nodiscard]] ImTextureID texture() const { return texture_; }
    /// Image pixels per texel and axis; more than 1 only where the window has fewer pixels.
    [[nodiscard]] int block() const { return block_; }
    [[nodiscard]] ValueRange range() const { return range_; }
    /// The color a visible pixel is shown in; for text on top of it.
    [[nodiscard]] framebuffer::Rgba8 shown(PixelPos pixel) const;
    /// Texels colored by the last update.
    [[nodiscard]] std::size_t painted() const { return painted_; }

private:
    /// What the texture shows; when it differs, everything is repainted.
    struct Subject {
        unsigned document = 0;
        ScreenContent content = ScreenContent::color;
        ThemeKind theme = ThemeKind::dark;
        int block = 1;
        std::optional<std::uint32_t> triangle; ///< of triangle views
        std::int32_t piece = 0;
        friend bool operator==(const Subject&, const Subject&) = default;
    };

    void resize(const PixelRect& image, Textures& textures);
    void measure(const Document& document);
    /// The texels that stand for some of these pixels.
    [[nodiscard]] PixelRect texels_of(const PixelRect& pixels) const;
    void mark_stale(const PixelRect& texels);
    /// Into `stale_`, of the tile in this column and row.
    [[nodiscard]] std::size_t tile_index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(tile_columns_) +
               static_cast<std::size_t>(column);
    }
    /// The stale tiles that these texels touch; they are no longer stale.
    std::vector<PixelRect> take_stale(const PixelRect& texels);
    void paint(const Document& document, std::span<const PixelRect> texels, const Theme& theme);
    template <typename ColorOf>
    void fill(std::span<const PixelRect> list, const PixelRect& image, const ColorOf& color_of);

    ImTextureID texture_ = nullptr;
    int width_ = 0; ///< of the texture
    int height_ = 0;
    int block_ = 1;
    std::vector<framebuffer::Rgba8> image_;
    int tile_columns_ = 0;
    std::vector<bool> stale_; ///< by tile, in rows: see tile_index
    std::optional<Subject> subject_;
    ValueRange range_;
    std::vector<framebuffer::Rgba8> count_colors_;
    std::size_t painted_ = 0;
};

/// The numbers a pixel shows when it is large enough, one line each; also what a legend reads out.
std::vector<std::string> pixel_numbers(Document& document, ScreenContent content, PixelPos pixel);

} // namespace hs::viewer
