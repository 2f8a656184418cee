// Who left what a pixel holds: the link from a value in the framebuffer to the fragment it came
// from.
#pragma once

#include "core/trace/recording.hpp"

namespace hs::trace {

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
