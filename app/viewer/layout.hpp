// Where each panel stands: one window, nothing floats, everything on a 4-pixel grid.
#pragma once

#include "app/viewer/state.hpp"
#include "app/viewer/theme.hpp"

namespace hs::viewer {

struct Layout {
    Rect menu;
    Rect strip;
    Rect left;
    Rect screen;
    Rect space; ///< no width when it is switched off
    Rect inspector;
    Rect sentence;
    Rect timeline;
};

Layout make_layout(ImVec2 window, const Theme& theme, bool show_space);

} // namespace hs::viewer
