// What the window shows and where it stands, in plain structs: panels read and write them, tests
// assert on them.
#pragma once

#include "app/viewer/theme.hpp"
#include "core/base/diagnostic.hpp"
#include "core/base/named.hpp"
#include "core/base/pixel.hpp"
#include "core/trace/step.hpp"

#include <imgui.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hs::viewer {

/// What the screen view shows of every pixel.
enum class ScreenContent : std::uint8_t {
    color,
    depth,
    triangle,
    overdraw,
    complexity,
    edge0,
    edge1,
    edge2,
    barycentric
};
inline constexpr int screen_content_count = 9;

/// Views that follow from the current triangle alone, not from the framebuffer.
[[nodiscard]] inline bool is_of_triangle(ScreenContent content) {
    return content >= ScreenContent::edge0;
}

enum class Space : std::uint8_t {
    object,
    world,
    eye,
    clip,
    ndc
};
inline constexpr int space_count = 5;

/// What stands beside the screen view.
enum class SidePanel : std::uint8_t {
    space,
    beside,
    projection,
    precision,
    clipping,
    cost,
    registers,
    normals,
    order,
    search
};
inline constexpr int side_panel_count = 10;

enum class InspectorTab : std::uint8_t {
    vertex,
    triangle,
    fragment,
    values,
    history,
    state
};
inline constexpr int inspector_tab_count = 6;

enum class LeftTab : std::uint8_t {
    lesson,
    scene
};

/// A rectangle of the window, in window pixels.
struct Rect {
    float x = 0.0F;
    float y = 0.0F;
    float width = 0.0F;
    float height = 0.0F;

    [[nodiscard]] float right() const { return x + width; }
    [[nodiscard]] float bottom() const { return y + height; }
    [[nodiscard]] bool contains(ImVec2 p) const {
        return p.x >= x && p.x < right() && p.y >= y && p.y < bottom();
    }
};

struct ScreenView {
    ScreenContent content = ScreenContent::color;
    bool fitted = true; ///< follows the panel's size until zoomed or panned
    float zoom = 1.0F;  ///< window pixels per image pixel
    ImVec2 center;      ///< the image position in the panel's middle
    bool show_grid = true;
    bool show_outline = true;
    bool show_numbers = true;
    bool show_helpers = false; ///< the pixels that only help with derivatives
    Rect area;                 ///< where the last frame drew
};

/// The second picture: the same pixels as the screen view, at the same size.
struct BesideView {
    bool by_count = false;        ///< follows by number of steps instead of by pixel
    bool show_difference = false; ///< marks pixels that differ in the finished pictures
    Rect area;                    ///< where the last frame drew
};

/// Eye, clip and NDC are stations of one way, on which the view volume becomes a box.
[[nodiscard]] inline bool is_on_the_way(Space space) {
    return space >= Space::eye;
}

struct SpaceView {
    Space space = Space::world;
    float morph = 0.0F; ///< on the way: 0 eye, 1 clip, 2 NDC; `space` is the nearest station
    std::optional<float> morph_goal; ///< while moving there by itself
    float morph_seconds = 0.0F;      ///< that the whole way takes then
    bool side = false;               ///< seen exactly from the side
    float yaw = 0.6F;                ///< radians
    float pitch = 0.35F;             ///< radians
    float distance = 1.0F;           ///< 1 shows everything
    Rect area;
};

/// Goes to a space: at once, or along the way from eye space to NDC within `seconds`.
void show_space(SpaceView& view, Space space, float seconds = 0.0F);
/// Puts a space view somewhere on the way.
void set_morph(SpaceView& view, float morph);
/// Moves on toward the goal, if there is one; otherwise stands on the station that `space` names.
void move_on(SpaceView& view, float seconds);

/// Near and far planes while they are dragged, before the frame is recorded with them.
struct PlanesDraft {
    float near = 0.1F;
    float far = 10.0F;
};

/// The expression to search for, while it is written.
struct SearchField {
    std::string text;
    std::string complaint; ///< what is wrong with it
    bool wants_keyboard = false;
};

/// The value whose formula is open, and the way that led to it.
struct ValueTrail {
    struct Stop {
        std::string step; ///< a path
        std::string value;
    };
    std::string open;       ///< its name; where the step has no such value, nothing is open
    int operand = -1;       ///< which of its operands is chosen
    bool scroll = false;    ///< bring it into sight
    std::vector<Stop> back; ///< the values left by following operands
};

/// The values of a step before the scene was changed under it, as texts by name.
struct ValuesBefore {
    std::string step; ///< a path; empty: nothing was changed yet
    std::map<std::string, std::string> texts;
};

enum class Prompt : std::uint8_t {
    none,
    open_file,
    export_file,
    go_to
};

inline constexpr float presentation_factor = 1.5F; ///< of large type for the lecture hall

struct State {
    trace::Granularity granularity = trace::Granularity::triangle;
    std::optional<PixelPos> selected; ///< the picked pixel
    std::optional<PixelPos> hovered;
    ScreenView screen;
    SpaceView space;
    BesideView beside;
    InspectorTab tab = InspectorTab::triangle;
    int corner = 0; ///< which vertex of the triangle the vertex tab shows
    LeftTab left = LeftTab::scene;
    SidePanel side = SidePanel::space;
    bool show_side = true;
    SearchField search;
    ValueTrail values;
    ValuesBefore values_before;
    bool show_why = false; ///< below a pixel's history
    std::optional<PlanesDraft> planes;
    bool log_distance = false; ///< axis of the depth plot
    ThemeKind theme = ThemeKind::dark;
    float presentation = 1.0F; ///< factor on all type and spacing
    bool show_keys = false;
    Prompt prompt = Prompt::none;
    bool prompt_appeared = false; ///< its field has the keyboard
    std::string prompt_text;
    std::string prompt_error;
    bool playing = false;
    float play_rate = 4.0F; ///< steps a second
    double since_played = 0.0;
    Diagnostics problems; ///< shown until dismissed
    std::string notice;   ///< one sentence about what could not be done
    std::vector<std::filesystem::path> recent;
    bool quit = false;
};

} // namespace hs::viewer

namespace hs {
template <>
std::span<const Named<viewer::ScreenContent>> names<viewer::ScreenContent>();
template <>
std::span<const Named<viewer::Space>> names<viewer::Space>();
template <>
std::span<const Named<viewer::SidePanel>> names<viewer::SidePanel>();
template <>
std::span<const Named<viewer::InspectorTab>> names<viewer::InspectorTab>();
} // namespace hs
