// Where each panel stands: one window, nothing floats, everything on a 4-pixel grid.
#pragma once

#include "app/viewer/state.hpp"
#include "app/viewer/theme.hpp"

#include <algorithm>
#include <vector>

namespace hs::viewer {

/// Between low and high; low where a tiny window leaves no room between them.
[[nodiscard]] inline float keep_within(float value, float low, float high) {
    return std::max(low, std::min(value, high));
}

struct Layout {
    Rect menu;
    Rect strip;
    Rect left;
    Rect screen;
    Rect side; ///< no width when it is switched off
    Rect inspector;
    Rect sentence;
    Rect timeline;
};

/// The stages that the strip shows from left to right, as the frame goes through them: visibility
/// only where it is a stage of its own, after setup where scanlines decide; rays need none of what
/// takes triangles to the window.
std::vector<trace::Stage> strip_stages(const scene::Settings& settings);

/// `side_share` of the middle belongs to the side panel; 0 when it is switched off.
Layout make_layout(ImVec2 window, const Theme& theme, float side_share);

} // namespace hs::viewer
