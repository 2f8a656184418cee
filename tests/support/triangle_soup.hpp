// Triangles that a rasterizer gets wrong if it gets anything wrong: vertices on pixel centers,
// corners and every finer lattice, slivers, specks, giants and triangles without area.
#pragma once

#include "core/base/pixel.hpp"
#include "tests/support/random_scene.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace hs::tests {

/// Where the vertices of a triangle lie, or what it looks like.
enum class SoupKind {
    anywhere,
    pixel_centers,
    pixel_corners,
    half_pixels,
    subpixels,     ///< multiples of 1/256 pixel: exactly what snapping can express
    subpixel_ties, ///< odd multiples of 1/512 pixel near pixel centers: snapping rounds a half
    slivers,
    tiny,
    huge, ///< reaching up to 1.4 images beyond the image
    degenerate,
};
inline constexpr std::uint32_t soup_kinds = 10;

/// Window positions in pixels, y down.
using WindowTriangle = std::array<glm::dvec2, 3>;

WindowTriangle soup_triangle(SoupKind kind, const PixelRect& image, Random& random);

/// The clip position that lands on a window position when the image is the viewport. With w = 1, on
/// the exact position for every one that is a multiple of 1/512 within a few thousand pixels.
glm::vec4 clip_at(const glm::dvec2& window, float ndc_z, float w, const PixelRect& image);

} // namespace hs::tests
