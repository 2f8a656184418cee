#include "app/viewer/screen_picture.hpp"

#include "core/explain/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hs::viewer {
namespace {

using framebuffer::pack;
using framebuffer::Rgba8;

constexpr glm::vec4 opaque_black{0.0F, 0.0F, 0.0F, 1.0F};

glm::vec4 mix(const glm::vec4& a, const glm::vec4& b, float t) {
    return a + (b - a) * t;
}

/// Neighboring numbers get hues far apart: multiples of the golden ratio.
Rgba8 triangle_color(std::uint32_t triangle) {
    if (triangle == trace::no_triangle) {
        return pack(opaque_black);
    }
    constexpr double golden = 0.61803398874989485;
    const double turns = static_cast<double>(triangle) * golden + 0.1;
    const auto hue = static_cast<float>(turns - std::floor(turns));
    const float value = triangle % 2 == 0 ? 0.92F : 0.72F;
    glm::vec4 color{0.0F, 0.0F, 0.0F, 1.0F};
    ImGui::ColorConvertHSVtoRGB(hue, 0.55F, value, color.r, color.g, color.b);
    return pack(color);
}

Rgba8 depth_color(const trace::PixelRecord& pixel, ValueRange range) {
    if (pixel.triangle == trace::no_triangle) {
        return pack({0.10F, 0.12F, 0.20F, 1.0F}); // nothing drawn: not a gray
    }
    const float span = range.high > range.low ? range.high - range.low : 1.0F;
    const float t = std::clamp((pixel.depth - range.low) / span, 0.0F, 1.0F);
    const float gray = 0.12F + 0.85F * t;
    return pack({gray, gray, gray, 1.0F});
}

/// Blue where the pixel lies on the triangle's side of the edge, orange elsewhere, pale near it.
Rgba8 edge_color(std::int64_t value, float largest) {
    const float size = std::fabs(static_cast<float>(value)) / std::max(1.0F, largest);
    const float t = std::sqrt(std::min(1.0F, size)) * 0.85F;
    const glm::vec4 pale{0.94F, 0.94F, 0.92F, 1.0F};
    const glm::vec4 inside{0.0F, 0.33F, 0.62F, 1.0F};
    const glm::vec4 outside{0.72F, 0.33F, 0.0F, 1.0F};
    return pack(mix(pale, value >= 0 ? inside : outside, 0.1F + t));
}

Rgba8 weights_color(const raster::TriangleSetup& setup, PixelPos pixel, const Theme& theme) {
    const raster::EdgeValues e = setup.evaluate(pixel);
    const auto weight = [&](unsigned k) {
        return static_cast<float>(e[k]) * setup.inv_doubled_area;
    };
    const std::array<float, 3> weights{weight(1), weight(2), weight(0)};
    glm::vec4 color{0.0F};
    constexpr std::array corners{Tone::vertex_0, Tone::vertex_1, Tone::vertex_2};
    for (unsigned k = 0; k < 3; ++k) {
        const ImVec4 corner = theme.vec4(corners[k]);
        color += std::clamp(weights[k], 0.0F, 1.0F) * glm::vec4{corner.x, corner.y, corner.z, 1.0F};
    }
    const float dim = setup.covers(e) ? 1.0F : 0.25F;
    return pack({color.r * dim, color.g * dim, color.b * dim, 1.0F});
}

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

} // namespace

ImU32 ink_on(Rgba8 ground) {
    const ImU32 black = IM_COL32(0, 0, 0, 255);
    const ImU32 white = IM_COL32(255, 255, 255, 255);
    const ImU32 solid = ground | IM_COL32_A_MASK;
    return contrast(solid, black) > contrast(solid, white) ? black : white;
}

Rgba8 count_color(std::uint32_t count, std::uint32_t most) {
    if (count == 0) {
        return pack(opaque_black);
    }
    // Steps of cividis (Nuñez, Anderton and Renslow 2018): readable without color vision
    static constexpr std::array<glm::vec4, 5> stops{{
        {0.00F, 0.19F, 0.43F, 1.0F},
        {0.26F, 0.31F, 0.42F, 1.0F},
        {0.49F, 0.49F, 0.47F, 1.0F},
        {0.73F, 0.67F, 0.42F, 1.0F},
        {1.00F, 0.92F, 0.27F, 1.0F},
    }};
    const float whole =
        most <= 1 ? 1.0F
                  : static_cast<float>(std::min(count, most) - 1) / static_cast<float>(most - 1);
    const float place = whole * static_cast<float>(stops.size() - 1);
    const std::size_t i = std::min(stops.size() - 2, static_cast<std::size_t>(place));
    return pack(mix(stops[i], stops[i + 1], place - static_cast<float>(i)));
}

Rgba8 ScreenPicture::shown(PixelPos pixel) const {
    const auto x = static_cast<std::size_t>(pixel.x / block_);
    const auto y = static_cast<std::size_t>(pixel.y / block_);
    return image_[y * static_cast<std::size_t>(width_) + x];
}

/// Triangle views are functions of the whole image: of a large one only every few pixels are asked.
void ScreenPicture::resize(const Document& document, ScreenContent content, Textures& textures) {
    constexpr int most_asked = 1 << 17;
    const PixelRect image = document.recording().settings().image();
    block_ = 1;
    while (is_of_triangle(content) &&
           (image.width() / block_) * (image.height() / block_) > most_asked) {
        ++block_;
    }
    const int width = (image.width() + block_ - 1) / block_;
    const int height = (image.height() + block_ - 1) / block_;
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
void ScreenPicture::measure(const Document& document, ScreenContent content) {
    range_ = {0.0F, 1.0F};
    const trace::PixelBuffer& pixels = document.recording().final_pixels;
    if (content == ScreenContent::depth) {
        ValueRange range{2.0F, -1.0F};
        pixels.for_each([&range](PixelPos, const trace::PixelRecord& pixel) {
            if (pixel.triangle != trace::no_triangle) {
                range.low = std::min(range.low, pixel.depth);
                range.high = std::max(range.high, pixel.depth);
            }
        });
        range_ = range.low <= range.high ? range : ValueRange{};
    } else if (content == ScreenContent::overdraw || content == ScreenContent::complexity) {
        std::uint16_t most = 1;
        const bool overdraw = content == ScreenContent::overdraw;
        pixels.for_each([&most, overdraw](PixelPos, const trace::PixelRecord& pixel) {
            most = std::max(most, overdraw ? pixel.overdraw : pixel.complexity);
        });
        range_ = {0.0F, static_cast<float>(most)};
    } else if (is_of_triangle(content) && content != ScreenContent::barycentric) {
        const trace::PieceDetail* piece = document.piece_detail();
        if (piece != nullptr && piece->setup) {
            const PixelRect image = document.recording().settings().image();
            range_.high = largest_at_corners(piece->setup->edges[edge_index(content)], image);
        }
    }
}

void ScreenPicture::paint(const Document& document, const PixelRect& texels, const Theme& theme) {
    const ScreenContent content = subject_->content;
    const trace::PieceDetail* piece = is_of_triangle(content) ? document.piece_detail() : nullptr;
    const raster::TriangleSetup* setup =
        piece != nullptr && piece->setup ? &*piece->setup : nullptr;
    const auto most = static_cast<std::uint32_t>(range_.high);
    const auto color_of = [&](PixelPos p) -> Rgba8 {
        constexpr Rgba8 alpha = 0xFF000000U;
        if (is_of_triangle(content)) {
            if (setup == nullptr) {
                return pack({0.25F, 0.25F, 0.25F, 1.0F});
            }
            return content == ScreenContent::barycentric
                       ? weights_color(*setup, p, theme)
                       : edge_color(setup->edges[edge_index(content)](p), range_.high);
        }
        const trace::PixelRecord& pixel = document.player().pixel(p);
        if (content == ScreenContent::color) {
            return pixel.color | alpha;
        }
        if (content == ScreenContent::depth) {
            return depth_color(pixel, range_);
        }
        if (content == ScreenContent::triangle) {
            return triangle_color(pixel.triangle);
        }
        const bool overdraw = content == ScreenContent::overdraw;
        return count_color(overdraw ? pixel.overdraw : pixel.complexity, most);
    };
    const PixelRect image = document.recording().settings().image();
    for (int y = texels.y0; y < texels.y1; ++y) {
        Rgba8* const out = &image_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_)];
        for (int x = texels.x0; x < texels.x1; ++x) {
            const PixelPos asked{
                std::min(image.x1 - 1, x * block_ + block_ / 2),
                std::min(image.y1 - 1, y * block_ + block_ / 2)};
            out[x] = color_of(asked);
        }
    }
}

void ScreenPicture::update(
    Document& document, ScreenContent content, const Theme& theme, Textures& textures
) {
    Subject subject{
        .document = document.revision(), .content = content, .theme = theme.kind, .triangle = {}};
    if (is_of_triangle(content)) {
        subject.triangle = document.current_triangle();
        subject.piece = document.player().current().piece;
    }
    const bool all = subject_ != subject;
    PixelRect changed = document.player().take_changed();
    if (all) {
        subject_ = subject;
        resize(document, content, textures);
        measure(document, content);
        changed = {0, 0, width_, height_};
    } else if (is_of_triangle(content)) {
        return;
    }
    if (!changed.empty()) {
        paint(document, changed, theme);
        textures.update(texture_, changed, image_);
    }
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
