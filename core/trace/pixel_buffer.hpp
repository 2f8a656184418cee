// The pixels of a recording and of its playhead, in tiles that copies share until one is written.
//
// A checkpoint, the finished picture and every playhead hold nearly the same pixels; copying all of
// them takes milliseconds at 1080p, copying the list of tiles takes microseconds. A square tile
// also keeps a small triangle's pixels within a few pages of memory.
#pragma once

#include "core/base/pixel.hpp"
#include "core/framebuffer/color.hpp"
#include "core/scene/settings.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hs::trace {

inline constexpr std::uint32_t no_fragment = 0xFFFFFFFFU;
inline constexpr std::uint32_t no_triangle = 0xFFFFFFFFU;

/// What a pixel holds, beside its color in rgba32f frames.
struct PixelRecord {
    framebuffer::Rgba8 color = 0;
    float depth = 0.0F;
    std::uint32_t triangle = no_triangle;      ///< owner, over the whole frame in file order
    std::uint32_t last_fragment = no_fragment; ///< the last that reached it, whatever its fate
    std::uint16_t complexity = 0; ///< fragments generated here; 65535 means "that many or more"
    std::uint16_t overdraw = 0;   ///< fragments written here; likewise
    friend bool operator==(const PixelRecord&, const PixelRecord&) = default;
};
static_assert(sizeof(PixelRecord) == 20);

/// All pixels of an image. Copying is cheap and leaves the pixels shared; writing through one copy
/// never shows in another. Copies may live on different threads.
class PixelBuffer {
public:
    static constexpr int tile_bits = 5;
    static constexpr int tile_side = 1 << tile_bits; ///< pixels

    PixelBuffer() = default;
    /// Every pixel as it is before the first fragment.
    explicit PixelBuffer(const scene::Settings& settings);

    [[nodiscard]] const PixelRecord& operator[](PixelPos p) const {
        return tiles_[tile_of(p)]->pixels[place_of(p)];
    }
    /// For writing: the tile becomes this buffer's own.
    [[nodiscard]] PixelRecord& writable(PixelPos p) { return own_tile(p).pixels[place_of(p)]; }

    /// The format's exact colors are beside the records: rgba32f frames.
    [[nodiscard]] bool float_color() const { return float_color_; }
    /// The color as its format holds it.
    [[nodiscard]] glm::vec4 color(PixelPos p) const {
        return float_color_ ? tiles_[tile_of(p)]->color32f[place_of(p)]
                            : framebuffer::unpack((*this)[p].color);
    }
    /// Precondition: float_color().
    void set_color32f(PixelPos p, const glm::vec4& color) {
        own_tile(p).color32f[place_of(p)] = color;
    }

    /// Calls `visit(position, record)` for every pixel, tile by tile.
    template <typename Visit>
    void for_each(Visit&& visit) const;

    /// A rectangle outside of which both buffers hold the same; both are of the same image.
    [[nodiscard]] PixelRect difference(const PixelBuffer& other) const;

    /// Memory if nothing were shared.
    [[nodiscard]] std::size_t bytes() const;
    /// Memory of several buffers, shared tiles counted once.
    [[nodiscard]] static std::size_t bytes_together(std::span<const PixelBuffer* const> buffers);

private:
    static constexpr std::size_t tile_area = std::size_t{tile_side} * tile_side;
    struct Tile {
        std::array<PixelRecord, tile_area> pixels;
        std::vector<glm::vec4> color32f; ///< rgba32f frames only, else empty
    };

    [[nodiscard]] std::size_t tile_of(PixelPos p) const {
        const auto column = static_cast<unsigned>(p.x) >> tile_bits;
        const auto row = static_cast<unsigned>(p.y) >> tile_bits;
        return std::size_t{row} * tiles_across_ + column;
    }
    [[nodiscard]] static std::size_t place_of(PixelPos p) {
        constexpr unsigned mask = tile_side - 1;
        return (static_cast<unsigned>(p.y) & mask) << tile_bits |
               (static_cast<unsigned>(p.x) & mask);
    }
    [[nodiscard]] Tile& own_tile(PixelPos p) {
        std::shared_ptr<Tile>& tile = tiles_[tile_of(p)];
        if (tile.use_count() != 1) {
            separate(tile);
        }
        return *tile;
    }
    static void separate(std::shared_ptr<Tile>& tile);
    [[nodiscard]] std::size_t bytes_per_tile() const;
    [[nodiscard]] PixelRect rect_of_tile(std::size_t tile) const;

    int width_ = 0;
    int height_ = 0;
    std::size_t tiles_across_ = 0;
    bool float_color_ = false;
    std::vector<std::shared_ptr<Tile>> tiles_; ///< row by row; those at the rim reach beyond it
};

template <typename Visit>
void PixelBuffer::for_each(Visit&& visit) const {
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
        const PixelRect rect = rect_of_tile(tile);
        for (int y = rect.y0; y < rect.y1; ++y) {
            for (int x = rect.x0; x < rect.x1; ++x) {
                visit(PixelPos{x, y}, tiles_[tile]->pixels[place_of({x, y})]);
            }
        }
    }
}

} // namespace hs::trace
