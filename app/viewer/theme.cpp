#include "app/viewer/theme.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace hs::viewer {
namespace {

// Okabe and Ito, Color Universal Design, 2008, for everything that is a category; darker variants
// on light ground, so that text and thin lines keep their contrast.
// clang-format off
constexpr std::array<ToneRow, tone_count> tones{{
    {Tone::window,    "window",    0x14171c, 0xe4e7eb},
    {Tone::panel,     "panel",     0x1c2027, 0xfafbfc},
    {Tone::raised,    "raised",    0x2b313b, 0xe3e7ec},
    {Tone::hovered,   "hovered",   0x3a424f, 0xd2d8e0},
    {Tone::hairline,  "hairline",  0x353c47, 0xc3cad3},
    {Tone::text,      "text",      0xe6e9ee, 0x1b2027},
    {Tone::quiet,     "quiet",     0x9fa8b5, 0x56606d},
    {Tone::accent,    "accent",    0xf0c543, 0x8a5a00},
    {Tone::on_accent, "on_accent", 0x1a1c20, 0xffffff},
    {Tone::changed,   "changed",   0x4a4220, 0xffe9a8},
    {Tone::pass,      "pass",      0x56b4e9, 0x0066a8},
    {Tone::fail,      "fail",      0xe69f00, 0x9a5200},
    {Tone::axis_x,    "axis_x",    0xe0824f, 0xb04a00},
    {Tone::axis_y,    "axis_y",    0x3fbf92, 0x00704f},
    {Tone::axis_z,    "axis_z",    0x56b4e9, 0x0066a8},
    {Tone::vertex_0,  "vertex_0",  0xe69f00, 0x9a5200},
    {Tone::vertex_1,  "vertex_1",  0x3fbf92, 0x00704f},
    {Tone::vertex_2,  "vertex_2",  0xcc79a7, 0x9b3f74},
    {Tone::canvas,    "canvas",    0x0c0e11, 0xb9bfc7},
    {Tone::grid,      "grid",      0x6b7480, 0x808a96},
    {Tone::outline,   "outline",   0xf0e442, 0xf0e442},
    {Tone::halo,      "halo",      0x000000, 0x000000},
    {Tone::selected,  "selected",  0xff8ad8, 0xb5178a},
}};

struct StageColor { std::uint32_t dark; std::uint32_t light; };
constexpr std::array<StageColor, trace::stage_count> stage_colors{{
    {0x9fa8b5, 0x56606d}, // application
    {0x3fbf92, 0x00704f}, // vertex
    {0x8fb3ff, 0x2c55b8}, // visibility
    {0xe69f00, 0x9a5200}, // clip
    {0xd184b0, 0x9b3f74}, // divide
    {0x56b4e9, 0x0066a8}, // viewport
    {0xe0824f, 0xa84600}, // cull
    {0xb7a3f0, 0x5b46a8}, // setup
    {0xf0e442, 0x6b6400}, // traverse
    {0xf29bb6, 0xa53a5f}, // shade
    {0x7fd6d6, 0x0a6c6c}, // test
    {0xa6d46a, 0x42700c}, // merge
}};
// clang-format on

ImU32 opaque(std::uint32_t rgb) {
    return IM_COL32((rgb >> 16U) & 0xFFU, (rgb >> 8U) & 0xFFU, rgb & 0xFFU, 0xFFU);
}

float linear_channel(ImU32 color, unsigned shift) {
    const float c = static_cast<float>((color >> shift) & 0xFFU) / 255.0F;
    return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F);
}

float luminance(ImU32 color) {
    return 0.2126F * linear_channel(color, IM_COL32_R_SHIFT) +
           0.7152F * linear_channel(color, IM_COL32_G_SHIFT) +
           0.0722F * linear_channel(color, IM_COL32_B_SHIFT);
}

} // namespace

std::span<const ToneRow> tone_table() {
    return tones;
}

float contrast(ImU32 a, ImU32 b) {
    const float la = luminance(a) + 0.05F;
    const float lb = luminance(b) + 0.05F;
    return std::max(la, lb) / std::min(la, lb);
}

ImU32 Theme::operator[](Tone tone) const {
    const ToneRow& row = tones[static_cast<std::size_t>(tone)];
    HS_DCHECK(row.tone == tone, "the table lists tones in order");
    return opaque(kind == ThemeKind::dark ? row.dark : row.light);
}

ImU32 Theme::faded(Tone tone, float alpha) const {
    const auto a = static_cast<ImU32>(std::clamp(alpha, 0.0F, 1.0F) * 255.0F);
    return ((*this)[tone] & ~IM_COL32_A_MASK) | (a << static_cast<unsigned>(IM_COL32_A_SHIFT));
}

ImVec4 Theme::vec4(Tone tone) const {
    return ImGui::ColorConvertU32ToFloat4((*this)[tone]);
}

ImU32 Theme::stage(trace::Stage stage) const {
    const StageColor& row = stage_colors[static_cast<std::size_t>(stage)];
    return opaque(kind == ThemeKind::dark ? row.dark : row.light);
}

void apply_style(const Theme& theme) {
    ImGuiStyle style;
    style.WindowPadding = {theme.units(3), theme.units(2)};
    style.FramePadding = {theme.units(2), theme.units(1)};
    style.ItemSpacing = {theme.units(2), theme.units(1)};
    style.ItemInnerSpacing = {theme.units(1), theme.units(1)};
    style.CellPadding = {theme.units(1), theme.pixels(2)};
    style.ScrollbarSize = theme.units(3);
    style.GrabMinSize = theme.units(3);
    style.IndentSpacing = theme.units(4);
    style.WindowBorderSize = 0.0F;
    style.ChildBorderSize = 0.0F;
    style.FrameBorderSize = 0.0F;
    style.PopupBorderSize = 1.0F;
    style.WindowRounding = 0.0F;
    style.ChildRounding = 0.0F;
    style.PopupRounding = theme.units(1);
    style.FrameRounding = theme.pixels(3);
    style.GrabRounding = theme.pixels(3);
    style.ScrollbarRounding = theme.pixels(3);
    style.AntiAliasedLinesUseTex = false; // its texture wants smoothing, which our core lacks

    const auto set = [&](ImGuiCol color, Tone tone) { style.Colors[color] = theme.vec4(tone); };
    set(ImGuiCol_Text, Tone::text);
    set(ImGuiCol_TextDisabled, Tone::quiet);
    set(ImGuiCol_WindowBg, Tone::panel);
    set(ImGuiCol_ChildBg, Tone::panel);
    set(ImGuiCol_PopupBg, Tone::panel);
    set(ImGuiCol_Border, Tone::hairline);
    set(ImGuiCol_FrameBg, Tone::raised);
    set(ImGuiCol_FrameBgHovered, Tone::hovered);
    set(ImGuiCol_FrameBgActive, Tone::hovered);
    set(ImGuiCol_TitleBg, Tone::raised);
    set(ImGuiCol_TitleBgActive, Tone::raised);
    set(ImGuiCol_MenuBarBg, Tone::panel);
    set(ImGuiCol_ScrollbarBg, Tone::panel);
    set(ImGuiCol_ScrollbarGrab, Tone::raised);
    set(ImGuiCol_ScrollbarGrabHovered, Tone::hovered);
    set(ImGuiCol_ScrollbarGrabActive, Tone::hovered);
    set(ImGuiCol_CheckMark, Tone::accent);
    set(ImGuiCol_SliderGrab, Tone::accent);
    set(ImGuiCol_SliderGrabActive, Tone::accent);
    set(ImGuiCol_Button, Tone::raised);
    set(ImGuiCol_ButtonHovered, Tone::hovered);
    set(ImGuiCol_ButtonActive, Tone::hovered);
    set(ImGuiCol_Header, Tone::raised);
    set(ImGuiCol_HeaderHovered, Tone::hovered);
    set(ImGuiCol_HeaderActive, Tone::hovered);
    set(ImGuiCol_Separator, Tone::hairline);
    set(ImGuiCol_TableBorderLight, Tone::hairline);
    set(ImGuiCol_TableBorderStrong, Tone::hairline);
    set(ImGuiCol_TableHeaderBg, Tone::panel);
    set(ImGuiCol_TextSelectedBg, Tone::hovered);
    set(ImGuiCol_PlotHistogram, Tone::accent);
    style.Colors[ImGuiCol_TableRowBg] = {0.0F, 0.0F, 0.0F, 0.0F};
    style.Colors[ImGuiCol_ModalWindowDimBg] = {0.0F, 0.0F, 0.0F, 0.5F};
    ImGui::GetStyle() = style;
}

} // namespace hs::viewer
