// What is drawn over and around the screen view's picture.
#pragma once

#include "app/viewer/panels.hpp"

namespace hs::viewer {

/// Where the image's top-left corner lies in the window.
ImVec2 image_origin(const ScreenView& view);

/// Pixels of the image that are at least partly in the view's area.
PixelRect visible_pixels(const ScreenView& view, const PixelRect& image);

/// The picture itself, clipped to its area.
void draw_pixels(Context& context, const ScreenPicture& picture);

/// Grid, numbers, the current triangle, the visited and the picked pixel.
void draw_overlays(Context& context, const ScreenPicture& picture);

/// What the colors mean.
void draw_legend(Context& context, const ScreenPicture& picture, const Rect& rect);

} // namespace hs::viewer
