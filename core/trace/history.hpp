// Pixel history: every fragment that reached a pixel, in order.
#pragma once

#include "core/trace/detail.hpp"
#include "core/trace/recording.hpp"

#include <vector>

namespace hs::trace {

struct HistoryRow {
    std::uint32_t fragment = 0;
    std::uint32_t object = 0;
    std::uint32_t triangle = 0;       ///< of the object
    std::uint32_t frame_triangle = 0; ///< over the whole frame
    StepId triangle_step = 0; ///< first step of its triangle, cheap; exact: last_step_of_fragment
    float depth = 0.0F;
    float stored_depth = 0.0F; ///< before
    glm::vec4 before{0.0F};
    glm::vec4 after{0.0F};
    fragment::FragmentFate fate = fragment::FragmentFate::written;
};

struct PixelHistory {
    PixelPos pixel;
    glm::vec4 initial_color{0.0F};
    float initial_depth = 1.0F;
    std::vector<HistoryRow> rows; ///< in execution order
    std::uint64_t left_out = 0;   ///< earlier fragments beyond `limit`
    glm::vec4 final_color{0.0F};
    float final_depth = 1.0F;
};

/// The last `limit` fragments that reached the pixel. Precondition: the pixel lies in the image.
PixelHistory pixel_history(const Recording& recording, PixelPos pixel, std::size_t limit = 4096);

/// What a fragment may leave in a pixel.
enum class Left : std::uint8_t {
    color,
    depth
};

/// The last fragment, from `fragment` backward through those of its pixel, that left its color or
/// its depth there: in a sample, or with −1 in the pixel; no_fragment: the pixel is as cleared.
std::uint32_t
last_writer(const Recording& recording, std::uint32_t fragment, int sample, Left what);

} // namespace hs::trace
