// The colors of the screen view: from what a pixel holds to what is shown of it. Each is asked for
// hundreds of thousands of pixels in one frame of the window, so what repeats stands in tables.
#pragma once

#include "app/viewer/theme.hpp"
#include "core/framebuffer/color.hpp"
#include "core/raster/triangle_setup.hpp"
#include "core/trace/recording.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace hs::viewer {

/// What values a view's colors span.
struct ValueRange {
    float low = 0.0F;
    float high = 1.0F;
    friend bool operator==(const ValueRange&, const ValueRange&) = default;
};

/// Text colors for a ground: black or white, whichever is easier to read.
ImU32 ink_on(framebuffer::Rgba8 ground);

/// The color of a count from 0 (dark) to `most` (bright), even in lightness.
framebuffer::Rgba8 count_color(std::uint32_t count, std::uint32_t most);

/// The colors of the counts 0 … `most`.
std::vector<framebuffer::Rgba8> count_colors(std::uint32_t most);

/// Neighboring numbers get hues far apart.
framebuffer::Rgba8 triangle_color(std::uint32_t triangle);

/// Dark is near; what nothing was drawn on is not a gray.
class DepthColors {
public:
    explicit DepthColors(ValueRange range);
    [[nodiscard]] framebuffer::Rgba8 operator()(const trace::PixelRecord& pixel) const;

private:
    ValueRange range_;
    float scale_;
};

/// Blue where a pixel lies on the triangle's side of an edge, orange elsewhere, pale near it.
class EdgeColors {
public:
    EdgeColors(const raster::EdgeFunction& edge, float largest);
    [[nodiscard]] framebuffer::Rgba8 operator()(PixelPos pixel) const;

private:
    static constexpr std::size_t shades = 256;
    raster::EdgeFunction edge_;
    float inv_largest_;
    std::array<framebuffer::Rgba8, shades> inside_{};
    std::array<framebuffer::Rgba8, shades> outside_{};
};

/// The corners' colors mixed by the barycentric weights, dimmed outside of the triangle.
class WeightColors {
public:
    WeightColors(const raster::TriangleSetup& setup, const Theme& theme);
    [[nodiscard]] framebuffer::Rgba8 operator()(PixelPos pixel) const;

private:
    raster::TriangleSetup setup_;
    std::array<glm::vec4, 3> corners_{}; ///< by edge function: E01 weighs vertex 2; 0 … 255
};

} // namespace hs::viewer
