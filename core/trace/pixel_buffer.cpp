#include "core/trace/pixel_buffer.hpp"

#include "core/framebuffer/depth.hpp"

#include <algorithm>
#include <unordered_set>

namespace hs::trace {
namespace {

/// The smallest rectangle around both.
PixelRect enclose(const PixelRect& a, const PixelRect& b) {
    if (a.empty()) {
        return b;
    }
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

} // namespace

PixelBuffer::PixelBuffer(const scene::Settings& settings)
    : width_(settings.width),
      height_(settings.height),
      tiles_across_(static_cast<std::size_t>((settings.width + tile_side - 1) / tile_side)),
      float_color_(settings.color_format == scene::ColorFormat::rgba32f) {
    PixelRecord clear;
    clear.color = framebuffer::pack(settings.background);
    clear.depth = framebuffer::store_depth(settings.depth_clear(), settings.depth_format);
    const auto cleared = std::make_shared<Tile>();
    cleared->pixels.fill(clear);
    if (float_color_) {
        cleared->color32f.assign(tile_area, settings.background);
    }
    const auto tiles_down = static_cast<std::size_t>((height_ + tile_side - 1) / tile_side);
    tiles_.assign(tiles_across_ * tiles_down, cleared);
}

void PixelBuffer::separate(std::shared_ptr<Tile>& tile) {
    tile = std::make_shared<Tile>(*tile);
}

PixelRect PixelBuffer::rect_of_tile(std::size_t tile) const {
    const int x = static_cast<int>(tile % tiles_across_) * tile_side;
    const int y = static_cast<int>(tile / tiles_across_) * tile_side;
    return intersect({x, y, x + tile_side, y + tile_side}, {0, 0, width_, height_});
}

PixelRect PixelBuffer::difference(const PixelBuffer& other) const {
    PixelRect rect;
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
        if (tiles_[tile] != other.tiles_[tile]) {
            rect = enclose(rect, rect_of_tile(tile));
        }
    }
    return rect;
}

std::size_t PixelBuffer::bytes_per_tile() const {
    return sizeof(Tile) + (float_color_ ? tile_area * sizeof(glm::vec4) : 0);
}

std::size_t PixelBuffer::bytes() const {
    return tiles_.size() * (bytes_per_tile() + sizeof(std::shared_ptr<Tile>));
}

std::size_t PixelBuffer::bytes_together(std::span<const PixelBuffer* const> buffers) {
    std::unordered_set<const Tile*> tiles;
    std::size_t total = 0;
    for (const PixelBuffer* buffer : buffers) {
        total += buffer->tiles_.size() * sizeof(std::shared_ptr<Tile>);
        for (const std::shared_ptr<Tile>& tile : buffer->tiles_) {
            total += tiles.insert(tile.get()).second ? buffer->bytes_per_tile() : 0;
        }
    }
    return total;
}

} // namespace hs::trace
