// Why a triangle is, or is not, what a pixel shows: where its way to the pixel ended, with the
// numbers, in one sentence.
#pragma once

#include "core/base/named.hpp"
#include "core/trace/player.hpp"

#include <string>
#include <vector>

namespace hs::explain {

/// Where a triangle's way to a pixel ended.
enum class PixelRole : std::uint8_t {
    shows,
    overwritten,
    depth_failed,
    scissor_failed,
    pixel_closed,
    not_drawn_yet,
    stuck,
    outside,
    cut_away,
    behind_the_eye,
    too_large,
    back_facing,
    front_facing,
    degenerate,
    beyond_viewport,
    hidden,
    not_covered,
};

struct TriangleAtPixel {
    std::uint32_t triangle = 0; ///< over the whole frame; lines and points count, too
    PixelRole role = PixelRole::not_covered;
    std::string sentence;
    trace::StepId step = 0; ///< where it was decided
};

/// At the player's step. Preconditions: the pixel lies in the image, the triangle exists.
TriangleAtPixel
triangle_at_pixel(const trace::Player& player, PixelPos pixel, std::uint32_t triangle);

/// Every triangle that could have colored the pixel, in file order: those whose projection holds
/// its center, before anything is clipped, culled or tested, and those that did reach it.
std::vector<TriangleAtPixel> triangles_at_pixel(const trace::Player& player, PixelPos pixel);

} // namespace hs::explain

namespace hs {
template <>
std::span<const Named<explain::PixelRole>> names<explain::PixelRole>();
} // namespace hs
