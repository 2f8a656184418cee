// The panels, one file each (panel_*.cpp), and what they share.
#pragma once

#include "app/viewer/document.hpp"
#include "app/viewer/layout.hpp"
#include "app/viewer/state.hpp"
#include "app/viewer/textures.hpp"
#include "app/viewer/theme.hpp"

namespace hs::viewer {

class Viewer;
class ScreenPicture;
class SpaceLines;
class TimelineBands;

/// What a panel may read and change during one frame.
struct Context {
    Viewer& viewer; ///< runs commands and long work
    Document& document;
    State& state;
    const Theme& theme;
    Textures& textures;
};

void draw_menu(Context& context, const Rect& rect);
void draw_strip(Context& context, const Rect& rect);
void draw_left(Context& context, const Rect& rect);
void draw_lesson(Context& context);
void draw_scene(Context& context);
void draw_screen(Context& context, const Rect& rect, ScreenPicture& picture);
void draw_side(Context& context, const Rect& rect, SpaceLines& lines);
// What stands in the side panel. Precondition: a document is open.
void draw_space(Context& context, const Rect& rect, SpaceLines& lines);
void draw_beside(Context& context, const Rect& rect);
void draw_projection(Context& context);
void draw_precision(Context& context);
void draw_clipping(Context& context);
void draw_cost(Context& context);
void draw_registers(Context& context);
void draw_normals(Context& context);
void draw_order(Context& context);
void draw_search(Context& context);
void draw_inspector(Context& context, const Rect& rect);
void draw_vertex_tab(Context& context);
void draw_triangle_tab(Context& context);
void draw_fragment_tab(Context& context);
void draw_values_tab(Context& context);
void draw_history_tab(Context& context);
/// Below the history: why the pixel has its color, and why other triangles do not show.
void draw_why(Context& context, PixelPos pixel);
void draw_state_tab(Context& context);
void draw_sentence(Context& context, const Rect& rect);
void draw_timeline(Context& context, const Rect& rect, TimelineBands& bands);

/// Windows above the panels: keys, prompts, problems, progress.
void draw_popups(Context& context, ImVec2 window);

} // namespace hs::viewer
