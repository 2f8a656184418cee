// One picture of a framebuffer with what the mouse does in it: the screen panel shows it, and the
// panel beside it shows a second one of the same pixels.
#pragma once

#include "app/viewer/panels.hpp"

namespace hs::viewer {

/// Draws the context's document into `state.screen.area`. While fitted, the image is made to fit
/// into `room`.
void draw_screen_view(Context& context, ImVec2 room, ScreenPicture& picture);

/// Below the picture: which pixel, what it holds, and where pixels count from.
void draw_readout(Context& context, const Rect& rect);

} // namespace hs::viewer
