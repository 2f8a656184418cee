// What a lesson points at: quantities its step names under `highlight` are framed where panels show
// them.
#pragma once

#include "app/viewer/panels.hpp"
#include "core/base/pixel.hpp"

#include <string_view>
#include <vector>

namespace hs::viewer {

/// Whether the open lesson points at a quantity ("ndc.x"), or at the group it belongs to ("ndc").
bool points_at(Viewer& viewer, std::string_view quantity);

/// Whether it points at any of them.
bool points_at_any(Viewer& viewer, const std::vector<std::string_view>& quantities);

/// Frames the last item when the lesson points at one of these quantities.
void frame_if_pointed(const Context& context, const std::vector<std::string_view>& quantities);

/// A frame as everything that is pointed at has it.
void draw_pointing_frame(ImDrawList& list, const Theme& theme, ImVec2 min, ImVec2 max);

/// The pixels of all sets of pixels that the lesson points at and does not hide.
std::vector<PixelPos> pointed_pixels(Viewer& viewer);

} // namespace hs::viewer
