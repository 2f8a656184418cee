// The current scanline or ray on the picture.
#pragma once

#include "app/viewer/panels.hpp"

namespace hs::viewer {

/// The spans found so far in the colors of their triangles, the edge or pixel that is being
/// decided, and the outlines of the polygons the decision is about.
void draw_swept_row(Context& context);

} // namespace hs::viewer
