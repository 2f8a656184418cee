#include "app/viewer/widgets.hpp"

#include <algorithm>
#include <iterator>

namespace hs::viewer {
namespace {

const char* first(std::string_view text) {
    return text.data();
}
const char* last(std::string_view text) {
    return text.data() + text.size();
}

void wrapped(ImFont* font, std::string_view text, ImU32 color) {
    const UseFont use{font};
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(first(text), last(text));
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

/// The byte length of the UTF-8 character that begins with this byte.
std::size_t utf8_length(char lead) {
    const auto byte = static_cast<unsigned char>(lead);
    return byte < 0x80U ? 1U : byte < 0xE0U ? 2U : byte < 0xF0U ? 3U : 4U;
}

} // namespace

void begin_panel(const char* name, const Rect& rect, const Theme& theme, bool scrolls) {
    ImGui::SetCursorScreenPos({rect.x, rect.y});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, theme[Tone::panel]);
    const ImGuiWindowFlags fixed =
        ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    ImGui::BeginChild(
        name,
        {rect.width, rect.height},
        false,
        ImGuiWindowFlags_AlwaysUseWindowPadding | (scrolls ? ImGuiWindowFlags_None : fixed)
    );
}

void end_panel() {
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

void words(const Theme& theme, std::string_view text, Tone tone) {
    wrapped(theme.fonts.text, text, theme[tone]);
}

void caption(const Theme& theme, std::string_view text, Tone tone) {
    wrapped(theme.fonts.small, text, theme[tone]);
}

void heading(const Theme& theme, std::string_view text) {
    ImGui::Dummy({0.0F, theme.units(1)});
    wrapped(theme.fonts.strong, text, theme[Tone::text]);
}

void mono(const Theme& theme, std::string_view text, Tone tone) {
    wrapped(theme.fonts.mono, text, theme[tone]);
}

void small_mono(const Theme& theme, std::string_view text, Tone tone) {
    const UseFont use{theme.fonts.small_mono};
    ImGui::PushStyleColor(ImGuiCol_Text, theme[tone]);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void row(const Theme& theme, std::string_view label, std::string_view value, Tone tone) {
    const float left = ImGui::GetCursorPosX();
    wrapped(theme.fonts.text, label, theme[Tone::quiet]);
    const float label_end = left + ImGui::GetItemRectSize().x + theme.units(2);
    ImGui::SameLine(std::max(left + theme.units(24), label_end));
    ImGui::BeginGroup();
    wrapped(theme.fonts.mono, value, theme[tone]);
    ImGui::EndGroup();
}

void empty_note(const Theme& theme, std::string_view text) {
    ImGui::Dummy({0.0F, theme.units(2)});
    wrapped(theme.fonts.text, text, theme[Tone::quiet]);
}

void tooltip(std::string_view text) {
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        return;
    }
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0F);
    ImGui::TextUnformatted(first(text), last(text));
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool button(
    const Theme& theme, const char* label, std::string_view tip, std::string_view why, bool lit
) {
    const bool disabled = !why.empty();
    if (lit) {
        ImGui::PushStyleColor(ImGuiCol_Button, theme[Tone::hovered]);
        ImGui::PushStyleColor(ImGuiCol_Text, theme[Tone::accent]);
    } else if (disabled) {
        ImGui::PushStyleColor(ImGuiCol_Text, theme[Tone::quiet]);
    }
    ImGui::BeginDisabled(disabled);
    ImGui::PushStyleVar(ImGuiStyleVar_DisabledAlpha, 1.0F);
    const bool clicked = ImGui::Button(label);
    ImGui::PopStyleVar();
    ImGui::EndDisabled();
    if (lit || disabled) {
        ImGui::PopStyleColor(lit ? 2 : 1);
    }
    if (lit) {
        const ImVec2 min = ImGui::GetItemRectMin();
        const ImVec2 max = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddRectFilled(
            {min.x, max.y - theme.pixels(2)}, max, theme[Tone::accent]
        );
    }
    tooltip(disabled ? why : tip);
    return clicked;
}

namespace {

float width_of(const Segment& segment) {
    const std::string label{segment.label};
    return ImGui::CalcTextSize(label.c_str()).x + 2.0F * ImGui::GetStyle().FramePadding.x;
}

/// Lines that segments take side by side.
int lines_of(const Theme& theme, std::span<const Segment> list, float room) {
    int lines = 1;
    float used = 0.0F;
    for (const Segment& segment : list) {
        const float width = width_of(segment);
        const float gap = used > 0.0F ? theme.pixels(2) : 0.0F;
        if (used > 0.0F && used + gap + width > room) {
            ++lines;
            used = width;
        } else {
            used += gap + width;
        }
    }
    return lines;
}

int drop_down(const Theme& theme, std::span<const Segment> list, int chosen) {
    int clicked = -1;
    const std::string shown{list[static_cast<std::size_t>(chosen)].label};
    ImGui::SetNextItemWidth(-1.0F);
    if (!ImGui::BeginCombo("##choices", shown.c_str(), ImGuiComboFlags_HeightLargest)) {
        return clicked;
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string label{list[i].label};
        const bool disabled = !list[i].why.empty();
        ImGui::PushStyleColor(ImGuiCol_Text, theme[disabled ? Tone::quiet : Tone::text]);
        const ImGuiSelectableFlags flags =
            disabled ? ImGuiSelectableFlags_Disabled : ImGuiSelectableFlags_None;
        if (ImGui::Selectable(label.c_str(), static_cast<int>(i) == chosen, flags)) {
            clicked = static_cast<int>(i);
        }
        ImGui::PopStyleColor();
        tooltip(disabled ? list[i].why : list[i].tip);
    }
    ImGui::EndCombo();
    return clicked;
}

} // namespace

int segments(const Theme& theme, const char* id, std::span<const Segment> list, int chosen) {
    int clicked = -1;
    ImGui::PushID(id);
    constexpr int most_lines = 2;
    if (chosen >= 0 && lines_of(theme, list, ImGui::GetContentRegionAvail().x) > most_lines) {
        clicked = drop_down(theme, list, chosen);
        ImGui::PopID();
        return clicked;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {theme.pixels(2), theme.pixels(2)});
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string label{list[i].label};
        const float width = width_of(list[i]);
        if (i > 0) {
            ImGui::SameLine();
            if (ImGui::GetCursorScreenPos().x + width > right) {
                ImGui::NewLine();
            }
        }
        const bool lit = static_cast<int>(i) == chosen;
        if (button(theme, label.c_str(), list[i].tip, list[i].why, lit)) {
            clicked = static_cast<int>(i);
        }
    }
    ImGui::PopStyleVar();
    ImGui::PopID();
    return clicked;
}

void draw_text(
    ImDrawList& list, ImFont* font, ImVec2 position, ImU32 color, std::string_view text
) {
    const ImVec2 whole{
        static_cast<float>(static_cast<int>(position.x)),
        static_cast<float>(static_cast<int>(position.y))};
    list.AddText(font, font->FontSize, whole, color, first(text), last(text));
}

ImVec2 text_size(ImFont* font, std::string_view text) {
    constexpr float no_limit = 3.0e38F;
    return font->CalcTextSizeA(font->FontSize, no_limit, 0.0F, first(text), last(text));
}

std::string shorten(ImFont* font, std::string_view text, float width) {
    if (text_size(font, text).x <= width) {
        return std::string{text};
    }
    const float room = width - text_size(font, "…").x;
    std::size_t end = 0;
    while (end < text.size()) {
        const std::size_t next = std::min(text.size(), end + utf8_length(text[end]));
        if (text_size(font, text.substr(0, next)).x > room) {
            break;
        }
        end = next;
    }
    return std::string{text.substr(0, end)} + "…";
}

std::string fitting(ImFont* font, std::initializer_list<std::string_view> wordings, float width) {
    for (const std::string_view text : wordings) {
        if (text_size(font, text).x <= width) {
            return std::string{text};
        }
    }
    return shorten(font, *std::prev(wordings.end()), width);
}

std::string shorten_front(ImFont* font, std::string_view text, float width) {
    if (text_size(font, text).x <= width) {
        return std::string{text};
    }
    const float room = width - text_size(font, "…").x;
    std::size_t begin = 0;
    while (begin < text.size() && text_size(font, text.substr(begin)).x > room) {
        begin += std::min(text.size() - begin, utf8_length(text[begin]));
    }
    return "…" + std::string{text.substr(begin)};
}

void draw_mark(ImDrawList& list, ImVec2 center, float size, bool passed, const Theme& theme) {
    // Clockwise, as ImGui's smoothing of edges wants it
    const float toward = passed ? -1.0F : 1.0F;
    list.AddTriangleFilled(
        {center.x, center.y + toward * size * 0.75F},
        {center.x - toward * size, center.y - toward * size * 0.75F},
        {center.x + toward * size, center.y - toward * size * 0.75F},
        theme[passed ? Tone::pass : Tone::fail]
    );
}

} // namespace hs::viewer
