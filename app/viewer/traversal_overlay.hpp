// What the current triangle's traversal has done so far, drawn over the pixels: its path, tiles by
// verdict, spans and active edges.
#pragma once

#include "app/viewer/panels.hpp"

namespace hs::viewer {

/// Draws inside the screen view's area, below the marks of the current pixel. Nothing outside of
/// traversals.
void draw_traversal(Context& context);

} // namespace hs::viewer
