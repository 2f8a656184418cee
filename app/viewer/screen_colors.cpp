#include "app/viewer/screen_colors.hpp"

#include <algorithm>
#include <cmath>

namespace hs::viewer {
namespace {

using framebuffer::pack;
using framebuffer::Rgba8;

constexpr glm::vec4 opaque_black{0.0F, 0.0F, 0.0F, 1.0F};

glm::vec4 mix(const glm::vec4& a, const glm::vec4& b, float t) {
    return a + (b - a) * t;
}

/// Two rounds of the color circle, a bright and a darker one.
std::array<Rgba8, 512> make_hues() {
    std::array<Rgba8, 512> hues{};
    for (std::size_t i = 0; i < hues.size(); ++i) {
        const float hue = static_cast<float>(i % 256) / 256.0F;
        glm::vec4 color = opaque_black;
        ImGui::ColorConvertHSVtoRGB(hue, 0.55F, i < 256 ? 0.92F : 0.72F, color.r, color.g, color.b);
        hues[i] = pack(color);
    }
    return hues;
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

std::vector<Rgba8> count_colors(std::uint32_t most) {
    std::vector<Rgba8> colors(std::size_t{most} + 1);
    for (std::uint32_t count = 0; count <= most; ++count) {
        colors[count] = count_color(count, most);
    }
    return colors;
}

Rgba8 triangle_color(std::uint32_t triangle) {
    if (triangle == trace::no_triangle) {
        return pack(opaque_black);
    }
    // The upper bits of multiples of the golden ratio (times 2^32) are spread most evenly
    constexpr std::uint32_t golden = 0x9E3779B9U;
    static const std::array<Rgba8, 512> hues = make_hues();
    return hues[(triangle * golden + 0x1A000000U) >> 24U | (triangle & 1U) << 8U];
}

DepthColors::DepthColors(ValueRange range)
    : range_(range), scale_(range.high > range.low ? 1.0F / (range.high - range.low) : 1.0F) {}

Rgba8 DepthColors::operator()(const trace::PixelRecord& pixel) const {
    constexpr Rgba8 nothing = 0xFF331F1AU;
    if (pixel.triangle == trace::no_triangle) {
        return nothing;
    }
    const float t = std::clamp((pixel.depth - range_.low) * scale_, 0.0F, 1.0F);
    return framebuffer::to_unorm8(0.12F + 0.85F * t) * 0x010101U | IM_COL32_A_MASK;
}

EdgeColors::EdgeColors(const raster::EdgeFunction& edge, float largest)
    : edge_(edge), inv_largest_(1.0F / std::max(1.0F, largest)) {
    const glm::vec4 pale{0.94F, 0.94F, 0.92F, 1.0F};
    const glm::vec4 blue{0.0F, 0.33F, 0.62F, 1.0F};
    const glm::vec4 orange{0.72F, 0.33F, 0.0F, 1.0F};
    for (std::size_t i = 0; i < shades; ++i) {
        const float t = 0.1F + 0.85F * static_cast<float>(i) / static_cast<float>(shades - 1);
        inside_[i] = pack(mix(pale, blue, t));
        outside_[i] = pack(mix(pale, orange, t));
    }
}

Rgba8 EdgeColors::operator()(PixelPos pixel) const {
    const std::int64_t value = edge_(pixel);
    // The root shows small values near the edge, where they matter
    const float size = std::min(1.0F, std::fabs(static_cast<float>(value)) * inv_largest_);
    const auto shade = static_cast<std::size_t>(std::sqrt(size) * static_cast<float>(shades - 1));
    return value >= 0 ? inside_[shade] : outside_[shade];
}

WeightColors::WeightColors(const raster::TriangleSetup& setup, const Theme& theme) : setup_(setup) {
    constexpr std::array corner_of_edge{Tone::vertex_2, Tone::vertex_0, Tone::vertex_1};
    for (unsigned k = 0; k < 3; ++k) {
        const ImVec4 tone = theme.vec4(corner_of_edge[k]);
        corners_[k] = glm::vec4{tone.x, tone.y, tone.z, 1.0F} * 255.0F;
    }
}

Rgba8 WeightColors::operator()(PixelPos pixel) const {
    const raster::EdgeValues e = setup_.evaluate(pixel);
    const float dim = setup_.covers(e) ? 1.0F : 0.25F;
    glm::vec4 color{0.5F}; // rounds when cut to whole numbers
    for (unsigned k = 0; k < 3; ++k) {
        const float weight = static_cast<float>(e[k]) * setup_.inv_doubled_area;
        color += corners_[k] * (std::clamp(weight, 0.0F, 1.0F) * dim);
    }
    const auto channel = [](float v) {
        return static_cast<Rgba8>(static_cast<int>(std::min(v, 255.0F)));
    };
    return channel(color.r) | channel(color.g) << 8U | channel(color.b) << 16U | IM_COL32_A_MASK;
}

} // namespace hs::viewer
