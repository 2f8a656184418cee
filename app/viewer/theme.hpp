// How the window looks: one table of named colors, one scale of sizes, two faces of type.
#pragma once

#include "core/base/named.hpp"
#include "core/trace/step.hpp"

#include <imgui.h>

#include <cstdint>
#include <span>
#include <string_view>

namespace hs::viewer {

enum class ThemeKind : std::uint8_t {
    dark,
    light
};

/// What a color is for. Panels name a tone, never a color.
enum class Tone : std::uint8_t {
    window,    ///< behind everything
    panel,     ///< what text stands on
    raised,    ///< controls
    hovered,   ///< controls under the mouse
    hairline,  ///< between panels
    text,      ///< words and numbers
    quiet,     ///< labels and units
    accent,    ///< the playhead, what is selected
    on_accent, ///< text on the accent
    changed,   ///< behind what this step changed
    pass,      ///< ▲
    fail,      ///< ▼
    axis_x,
    axis_y,
    axis_z,
    vertex_0, ///< corner, edge function or weight 0
    vertex_1,
    vertex_2,
    canvas,   ///< behind pictures
    grid,     ///< pixel grid on pictures
    outline,  ///< the current triangle on pictures
    halo,     ///< under lines on pictures, so that they show on any color
    selected, ///< the picked pixel
};
inline constexpr int tone_count = static_cast<int>(Tone::selected) + 1;

struct ToneRow {
    Tone tone = Tone::window;
    std::string_view name;
    std::uint32_t dark = 0;  ///< 0xRRGGBB
    std::uint32_t light = 0; ///< 0xRRGGBB
};
std::span<const ToneRow> tone_table();

/// WCAG 2 contrast ratio of two colors, 1 … 21.
float contrast(ImU32 a, ImU32 b);

struct Fonts {
    ImFont* text = nullptr;       ///< words
    ImFont* strong = nullptr;     ///< titles
    ImFont* small = nullptr;      ///< captions
    ImFont* mono = nullptr;       ///< numbers
    ImFont* small_mono = nullptr; ///< numbers on pixels and in the strip
};

struct Theme {
    ThemeKind kind = ThemeKind::dark;
    float scale = 1.0F; ///< the display's times the presentation's
    Fonts fonts;

    [[nodiscard]] ImU32 operator[](Tone tone) const;
    [[nodiscard]] ImU32 faded(Tone tone, float alpha) const;
    [[nodiscard]] ImVec4 vec4(Tone tone) const;
    /// The hue of a stage, kept in strip, timeline and lessons.
    [[nodiscard]] ImU32 stage(trace::Stage stage) const;
    /// Multiples of the 4-pixel grid.
    [[nodiscard]] float units(float count) const { return 4.0F * scale * count; }
    [[nodiscard]] float pixels(float count) const { return count * scale; }
};

/// Loads both faces from where Debian keeps them, DejaVu and then ImGui's own where they are
/// absent. Replaces what the atlas had.
Fonts load_fonts(ImFontAtlas& atlas, float scale);

/// Sets ImGui's style from the theme.
void apply_style(const Theme& theme);

} // namespace hs::viewer
