#include "tests/support/triangle_soup.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <cmath>

namespace hs::tests {
namespace {

double uniform(Random& random, double low, double high) {
    return low + static_cast<double>(random.next() >> 11U) * 0x1p-53 * (high - low);
}

int integer(Random& random, int low, int high) {
    return low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low + 1)));
}

/// A point of the image and a margin around it.
glm::dvec2 anywhere(const PixelRect& image, double margin, Random& random) {
    const double w = image.width();
    const double h = image.height();
    return {
        uniform(random, -margin * w, (1.0 + margin) * w),
        uniform(random, -margin * h, (1.0 + margin) * h)};
}

/// Vertices at offset + i · step, in the whole image or within a few pixels of each other. A third
/// of the triangles get a horizontal or vertical edge: only there do top and bottom ties differ.
WindowTriangle
on_lattice(double step, double offset, double reach, const PixelRect& image, Random& random) {
    const glm::dvec2 around = anywhere(image, 0.1, random);
    WindowTriangle triangle;
    for (glm::dvec2& v : triangle) {
        const glm::dvec2 near{
            around.x + uniform(random, -reach, reach), around.y + uniform(random, -reach, reach)};
        const glm::dvec2 free = reach > 0.0 ? near : anywhere(image, 0.2, random);
        v = {offset + step * std::floor(free.x / step), offset + step * std::floor(free.y / step)};
    }
    if (random.one_in(3)) {
        triangle[1].y = triangle[0].y;
    } else if (random.one_in(3)) {
        triangle[1].x = triangle[0].x;
    }
    return triangle;
}

WindowTriangle
lattice_of_any_reach(double step, double offset, const PixelRect& image, Random& random) {
    const double most = std::min(image.width(), image.height());
    const double reach = random.one_in(2) ? 12.0 : 4.0;
    const bool whole_image = random.one_in(4);
    return on_lattice(step, offset, whole_image ? 0.0 : std::min(reach, most), image, random);
}

/// Odd multiples of 1/512 within 1/32 pixel of pixel centers: there, rounding the half the other
/// way decides whether the center is covered.
WindowTriangle ties(const PixelRect& image, Random& random) {
    WindowTriangle triangle = lattice_of_any_reach(1.0, 0.5, image, random);
    for (glm::dvec2& v : triangle) {
        v.x += (2 * integer(random, -8, 7) + 1) / 512.0;
        v.y += (2 * integer(random, -8, 7) + 1) / 512.0;
    }
    return triangle;
}

WindowTriangle sliver(const PixelRect& image, Random& random) {
    const glm::dvec2 a = anywhere(image, 0.2, random);
    const glm::dvec2 b = anywhere(image, 0.2, random);
    const double width = random.one_in(2) ? 0.02 : 0.5;
    const double along = uniform(random, 0.0, 1.0);
    const glm::dvec2 c{
        a.x + along * (b.x - a.x) + uniform(random, -width, width),
        a.y + along * (b.y - a.y) + uniform(random, -width, width)};
    return {a, b, c};
}

WindowTriangle speck(const PixelRect& image, Random& random) {
    const glm::dvec2 around = anywhere(image, 0.0, random);
    const double reach = random.one_in(2) ? 0.7 : 2.0;
    WindowTriangle triangle;
    for (glm::dvec2& v : triangle) {
        v = {around.x + uniform(random, -reach, reach), around.y + uniform(random, -reach, reach)};
    }
    return triangle;
}

/// A point, a doubled vertex, or three vertices on a line.
WindowTriangle without_area(const PixelRect& image, Random& random) {
    const WindowTriangle t = lattice_of_any_reach(1.0 / 128.0, 0.0, image, random);
    switch (random.below(4)) {
    case 0: return {t[0], t[0], t[0]};
    case 1: return {t[0], t[1], t[0]};
    case 2: return {t[0], t[1], t[1]};
    default: return {t[0], t[1], (t[0] + t[1]) / 2.0};
    }
}

} // namespace

WindowTriangle soup_triangle(SoupKind kind, const PixelRect& image, Random& random) {
    switch (kind) {
    case SoupKind::anywhere:
        return {
            anywhere(image, 0.2, random),
            anywhere(image, 0.2, random),
            anywhere(image, 0.2, random)};
    case SoupKind::pixel_centers: return lattice_of_any_reach(1.0, 0.5, image, random);
    case SoupKind::pixel_corners: return lattice_of_any_reach(1.0, 0.0, image, random);
    case SoupKind::half_pixels: return lattice_of_any_reach(0.5, 0.0, image, random);
    case SoupKind::subpixels: return lattice_of_any_reach(1.0 / 256.0, 0.0, image, random);
    case SoupKind::subpixel_ties: return ties(image, random);
    case SoupKind::slivers: return sliver(image, random);
    case SoupKind::tiny: return speck(image, random);
    case SoupKind::huge:
        return {
            anywhere(image, 1.4, random),
            anywhere(image, 1.4, random),
            anywhere(image, 1.4, random)};
    case SoupKind::degenerate: return without_area(image, random);
    }
    HS_CHECK(false, "every kind of triangle is handled");
    return {};
}

glm::vec4 clip_at(const glm::dvec2& window, float ndc_z, float w, const PixelRect& image) {
    const double half_width = image.width() / 2.0;
    const double half_height = image.height() / 2.0;
    const double x = (window.x - half_width) / half_width;
    const double y = -(window.y - half_height) / half_height;
    const auto wide_w = static_cast<double>(w);
    return {static_cast<float>(x * wide_w), static_cast<float>(y * wide_w), ndc_z * w, w};
}

} // namespace hs::tests
