// What the order panel shows where scanlines or rays decide.
#pragma once

#include "app/viewer/panels.hpp"

namespace hs::viewer {

/// Edge table, active edges, polygon table and spans of the current scanline; its line of depths;
/// or the hits of the current ray.
void draw_sweep(Context& context);

/// The color that stands for a polygon of the sweep, in panel and picture: its triangle's.
[[nodiscard]] ImU32 swept_color(const trace::Recording& recording, std::int32_t polygon);

} // namespace hs::viewer
