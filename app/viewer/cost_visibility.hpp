// What every visible-surface algorithm makes of the scene, side by side: part of the cost panel.
#pragma once

#include "app/viewer/panels.hpp"

namespace hs::viewer {

/// Tried on demand; a click on a row records the frame with that algorithm.
void draw_visibility_costs(Context& context);

} // namespace hs::viewer
