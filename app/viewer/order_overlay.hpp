// What an ordering decision is about, drawn over the pixels.
#pragma once

#include "app/viewer/panels.hpp"

namespace hs::viewer {

/// Outlines the two polygons of the current decision: ▲ the one that goes first, ▼ the other.
/// Nothing outside of ordering.
void draw_ordered_pair(Context& context);

} // namespace hs::viewer
