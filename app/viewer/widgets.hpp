// The few building blocks all panels are made of.
#pragma once

#include "app/viewer/state.hpp"
#include "app/viewer/theme.hpp"

#include <imgui.h>

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace hs::viewer {

/// Pushes a font for a scope.
class UseFont {
public:
    explicit UseFont(ImFont* font) { ImGui::PushFont(font); }
    UseFont(const UseFont&) = delete;
    UseFont& operator=(const UseFont&) = delete;
    UseFont(UseFont&&) = delete;
    UseFont& operator=(UseFont&&) = delete;
    ~UseFont() { ImGui::PopFont(); }
};

/// A panel at a fixed place. Contents between begin and end; `scrolls` only downward.
void begin_panel(const char* name, const Rect& rect, const Theme& theme, bool scrolls);
void end_panel();

/// Words, wrapped at the panel's edge.
void words(const Theme& theme, std::string_view text, Tone tone = Tone::text);
/// Words in the caption's size, wrapped.
void caption(const Theme& theme, std::string_view text, Tone tone = Tone::quiet);
/// A heading inside a panel.
void heading(const Theme& theme, std::string_view text);
/// Numbers and formulas, wrapped.
void mono(const Theme& theme, std::string_view text, Tone tone = Tone::text);
/// The same in small type.
void small_mono(const Theme& theme, std::string_view text, Tone tone = Tone::text);
/// A label and a monospaced value in two columns; the value wraps below itself.
void row(
    const Theme& theme, std::string_view label, std::string_view value, Tone tone = Tone::text
);
/// What would fill an empty panel.
void empty_note(const Theme& theme, std::string_view text);

/// A button that says why it is disabled. `why` empty: enabled. `tip` may be empty.
bool button(
    const Theme& theme,
    const char* label,
    std::string_view tip = {},
    std::string_view why = {},
    bool lit = false
);
void tooltip(std::string_view text);

/// One of several, side by side, wrapping to the next line; a list to drop down where that would
/// take more than two lines. Returns the one clicked, or −1.
struct Segment {
    std::string_view label;
    std::string_view tip;
    std::string_view why; ///< why it is disabled, or empty
};
int segments(const Theme& theme, const char* id, std::span<const Segment> list, int chosen);

/// Text at a place of a draw list, clipped by nothing.
void draw_text(ImDrawList& list, ImFont* font, ImVec2 position, ImU32 color, std::string_view text);
ImVec2 text_size(ImFont* font, std::string_view text);
/// The longest beginning that fits into `width`, with "…" where something is missing.
std::string shorten(ImFont* font, std::string_view text, float width);
/// The first of several wordings that fits, or the last one shortened.
std::string fitting(ImFont* font, std::initializer_list<std::string_view> wordings, float width);
/// The longest end that fits.
std::string shorten_front(ImFont* font, std::string_view text, float width);

/// ▲ or ▼ drawn as a shape, so that no font needs to have it.
void draw_mark(ImDrawList& list, ImVec2 center, float size, bool passed, const Theme& theme);

} // namespace hs::viewer
