#include "app/viewer/screen_picture.hpp"

#include "core/explain/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hs::viewer {
namespace {

using framebuffer::Rgba8;

constexpr int tile = 32; ///< texels

/// The largest absolute value of an edge function over the image: it lies at a corner.
float largest_at_corners(const raster::EdgeFunction& edge, const PixelRect& image) {
    const int x = image.width() - 1;
    const int y = image.height() - 1;
    float largest = 0.0F;
    for (const PixelPos corner : {PixelPos{0, 0}, PixelPos{x, 0}, PixelPos{0, y}, PixelPos{x, y}}) {
        largest = std::max(largest, std::fabs(static_cast<float>(edge(corner))));
    }
    return largest;
}

unsigned edge_index(ScreenContent content) {
    return static_cast<unsigned>(content) - static_cast<unsigned>(ScreenContent::edge0);
}

PixelRect united(const PixelRect& a, const PixelRect& b) {
    if (a.empty() || b.empty()) {
        return a.empty() ? b : a;
    }
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

int rounded_up(int size, int part) {
    return (size + part - 1) / part;
}

} // namespace

Rgba8 ScreenPicture::shown(PixelPos pixel) const {
    const auto x = static_cast<std::size_t>(pixel.x / block_);
    const auto y = static_cast<std::size_t>(pixel.y / block_);
    return image_[y * static_cast<std::size_t>(width_) + x];
}

void ScreenPicture::resize(const PixelRect& image, Textures& textures) {
    const int width = rounded_up(image.width(), block_);
    const int height = rounded_up(image.height(), block_);
    tile_columns_ = rounded_up(width, tile);
    stale_.assign(
        static_cast<std::size_t>(tile_columns_) *
            static_cast<std::size_t>(rounded_up(height, tile)),
        true
    );
    if (texture_ != nullptr && width == width_ && height == height_) {
        return;
    }
    if (texture_ != nullptr) {
        textures.destroy(texture_);
    }
    width_ = width;
    height_ = height;
    texture_ = textures.create(width, height);
    image_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
}

/// Ranges come from the finished frame, so that colors keep their meaning while stepping.
void ScreenPicture::measure(const Document& document) {
    range_ = {0.0F, 1.0F};
    const ScreenContent content = subject_->content;
    const PixelRanges& whole = document.ranges();
    if (content == ScreenContent::depth) {
        range_ = whole.depth;
    } else if (content == ScreenContent::overdraw || content == ScreenContent::complexity) {
        const std::uint16_t most =
            content == ScreenContent::overdraw ? whole.most_overdraw : whole.most_complexity;
        range_ = {0.0F, static_cast<float>(most)};
        count_colors_ = count_colors(most);
    } else if (is_of_triangle(content) && content != ScreenContent::barycentric) {
        const trace::PieceDetail* piece = document.piece_detail();
        if (piece != nullptr && piece->setup) {
            const PixelRect image = document.recording().settings().image();
            range_.high = largest_at_corners(piece->setup->edges[edge_index(content)], image);
        }
    }
}

PixelRect ScreenPicture::texels_of(const PixelRect& pixels) const {
    const PixelRect texels{
        pixels.x0 / block_,
        pixels.y0 / block_,
        rounded_up(pixels.x1, block_),
        rounded_up(pixels.y1, block_)};
    return intersect(texels, {0, 0, width_, height_});
}

void ScreenPicture::mark_stale(const PixelRect& texels) {
    for (int y = texels.y0 / tile; y < rounded_up(texels.y1, tile); ++y) {
        for (int x = texels.x0 / tile; x < rounded_up(texels.x1, tile); ++x) {
            stale_[tile_index(x, y)] = true;
        }
    }
}

std::vector<PixelRect> ScreenPicture::take_stale(const PixelRect& texels) {
    std::vector<PixelRect> list;
    for (int y = texels.y0 / tile; y < rounded_up(texels.y1, tile); ++y) {
        for (int x = texels.x0 / tile; x < rounded_up(texels.x1, tile); ++x) {
            const std::size_t index = tile_index(x, y);
            if (stale_[index]) {
                const PixelRect square{x * tile, y * tile, (x + 1) * tile, (y + 1) * tile};
                list.push_back(intersect(square, {0, 0, width_, height_}));
                stale_[index] = false;
            }
        }
    }
    return list;
}

/// Each texel shows the pixel in the middle of its block.
template <typename ColorOf>
void ScreenPicture::fill(
    std::span<const PixelRect> list, const PixelRect& image, const ColorOf& color_of
) {
    const auto middle = [this](int texel, int end) {
        return std::min(end - 1, texel * block_ + block_ / 2);
    };
    for (const PixelRect& texels : list) {
        for (int y = texels.y0; y < texels.y1; ++y) {
            const auto row_start = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
            Rgba8* const out = &image_[row_start];
            const int row = middle(y, image.y1);
            for (int x = texels.x0; x < texels.x1; ++x) {
                out[x] = color_of(PixelPos{middle(x, image.x1), row});
            }
        }
    }
}

void ScreenPicture::paint(
    const Document& document, std::span<const PixelRect> texels, const Theme& theme
) {
    constexpr Rgba8 alpha = IM_COL32_A_MASK;
    constexpr Rgba8 no_triangle = 0xFF404040U;
    const PixelRect image = document.recording().settings().image();
    const trace::Player& player = document.player();
    const ScreenContent content = subject_->content;
    const trace::PieceDetail* piece = is_of_triangle(content) ? document.piece_detail() : nullptr;
    if (is_of_triangle(content) && (piece == nullptr || !piece->setup)) {
        fill(texels, image, [](PixelPos) { return no_triangle; });
        return;
    }
    switch (content) {
    case ScreenContent::color:
        fill(texels, image, [&](PixelPos p) { return player.pixel(p).color | alpha; });
        return;
    case ScreenContent::depth:
        fill(texels, image, [&, colors = DepthColors{range_}](PixelPos p) {
            return colors(player.pixel(p));
        });
        return;
    case ScreenContent::triangle:
        fill(texels, image, [&](PixelPos p) { return triangle_color(player.pixel(p).triangle); });
        return;
    case ScreenContent::overdraw:
        fill(texels, image, [&](PixelPos p) { return count_colors_[player.pixel(p).overdraw]; });
        return;
    case ScreenContent::complexity:
        fill(texels, image, [&](PixelPos p) { return count_colors_[player.pixel(p).complexity]; });
        return;
    case ScreenContent::edge0:
    case ScreenContent::edge1:
    case ScreenContent::edge2:
        fill(texels, image, EdgeColors{piece->setup->edges[edge_index(content)], range_.high});
        return;
    case ScreenContent::barycentric:
        fill(texels, image, WeightColors{*piece->setup, theme});
        return;
    }
    HS_CHECK(false, "every content is painted");
}

void ScreenPicture::update(
    Document& document,
    const ScreenView& view,
    const PixelRect& visible,
    const Theme& theme,
    Textures& textures
) {
    painted_ = 0;
    // A texel is never wider than one and a half pixels of the window
    const int block = std::max(1, static_cast<int>(std::lround(1.0F / view.zoom)));
    Subject subject{
        .document = document.revision(),
        .content = view.content,
        .theme = theme.kind,
        .block = block,
        .triangle = {}};
    const bool of_triangle = is_of_triangle(view.content);
    if (of_triangle) {
        subject.triangle = document.current_triangle();
        subject.piece = document.player().current().piece;
    }
    const PixelRect changed = document.player().take_changed();
    if (subject_ != subject) {
        subject_ = subject;
        block_ = block;
        resize(document.recording().settings().image(), textures);
        measure(document);
    } else if (!of_triangle && !changed.empty()) {
        mark_stale(texels_of(changed));
    }

    const std::vector<PixelRect> list = take_stale(texels_of(visible));
    if (list.empty()) {
        return;
    }
    paint(document, list, theme);
    PixelRect fresh;
    for (const PixelRect& texels : list) {
        fresh = united(fresh, texels);
        painted_ += static_cast<std::size_t>(texels.width() * texels.height());
    }
    textures.update(texture_, fresh, image_);
}

std::vector<std::string> pixel_numbers(Document& document, ScreenContent content, PixelPos pixel) {
    if (is_of_triangle(content)) {
        const trace::PieceDetail* piece = document.piece_detail();
        if (piece == nullptr || !piece->setup) {
            return {};
        }
        const raster::EdgeValues e = piece->setup->evaluate(pixel);
        if (content == ScreenContent::barycentric) {
            const float inv_area = piece->setup->inv_doubled_area;
            const auto weight = [&](unsigned k) {
                return fmt::format("{:.2f}", static_cast<float>(e[k]) * inv_area);
            };
            return {weight(1), weight(2), weight(0)};
        }
        constexpr double unit = 65536.0; // of edge values: 1/65536 pixel²
        return {fmt::format("{:.2f}", static_cast<double>(e[edge_index(content)]) / unit)};
    }
    const trace::PixelRecord& record = document.player().pixel(pixel);
    if (content == ScreenContent::color) {
        const glm::vec4 color = document.player().color(pixel);
        if (document.recording().settings().color_format == scene::ColorFormat::rgba32f) {
            return {
                fmt::format("{:.2f}", color.r),
                fmt::format("{:.2f}", color.g),
                fmt::format("{:.2f}", color.b)};
        }
        const auto channel = [](float v) { return fmt::format("{}", framebuffer::to_unorm8(v)); };
        return {channel(color.r), channel(color.g), channel(color.b)};
    }
    if (content == ScreenContent::depth) {
        return {explain::number(record.depth)};
    }
    if (content == ScreenContent::triangle) {
        return {record.triangle == trace::no_triangle ? "" : fmt::format("{}", record.triangle)};
    }
    const bool overdraw = content == ScreenContent::overdraw;
    return {fmt::format(
        "{}", overdraw ? document.player().overdraw(pixel) : document.player().complexity(pixel)
    )};
}

} // namespace hs::viewer
