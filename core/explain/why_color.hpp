// Why a pixel has its color: from what it holds back through merging, shading and interpolation to
// a vertex, its clip coordinates and the row of the matrix they came from.
#pragma once

#include "core/explain/step_values.hpp"
#include "core/trace/player.hpp"

#include <vector>

namespace hs::explain {

/// One value on the way back.
struct ColorLink {
    trace::StepId step = 0;
    std::string path;
    StepValue value;
};

/// Back from the pixel at the player's step, by its strongest channel and the vertex with the
/// greatest weight: that one's color, weight and place. Precondition: the pixel lies in the image.
std::vector<ColorLink> why_this_color(const trace::Player& player, PixelPos pixel);

} // namespace hs::explain
