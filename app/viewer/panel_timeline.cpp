// The timeline: the whole frame, the current triangle under a lens, and the buttons that step.
#include "app/viewer/panels.hpp"
#include "app/viewer/search.hpp"
#include "app/viewer/timeline_bands.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace hs::viewer {
namespace {

/// Steps along a row of pixels.
struct Scale {
    Rect rect;
    trace::StepId first = 0;
    trace::StepId last = 1;

    [[nodiscard]] float x(trace::StepId step) const {
        const trace::StepId inside = std::clamp(step, first, last);
        const double part =
            last == first ? 0.5
                          : static_cast<double>(inside - first) / static_cast<double>(last - first);
        return rect.x + static_cast<float>(part * static_cast<double>(rect.width));
    }
    [[nodiscard]] trace::StepId step(float position) const {
        const double part = std::clamp(
            static_cast<double>(position - rect.x) / static_cast<double>(rect.width), 0.0, 1.0
        );
        return first +
               static_cast<trace::StepId>(std::llround(part * static_cast<double>(last - first)));
    }
};

void draw_bands(Context& context, const Scale& scale, std::span<const Band> bands) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Theme& theme = context.theme;
    const Rect& r = scale.rect;
    list.AddRectFilled({r.x, r.y}, {r.right(), r.bottom()}, theme[Tone::raised]);
    for (const Band& band : bands) {
        const float x0 = scale.x(band.first);
        const float x1 = std::max(x0 + 1.0F, scale.x(band.last + 1) - 1.0F);
        const ImU32 hue = theme.stage(band.stage);
        list.AddRectFilled({x0, r.bottom() - theme.pixels(3)}, {x1, r.bottom()}, hue);
        const float room = x1 - x0 - theme.units(2);
        ImFont* font = theme.fonts.small;
        if (room > text_size(font, band.label).x) {
            draw_text(list, font, {x0 + theme.units(1), r.y}, theme[Tone::text], band.label);
        }
    }
}

/// ▲ and ▼ where the picked pixel's fragments met their fate; at most one per pixel of the row.
void draw_marks(Context& context, const Scale& scale, const TimelineBands& bands) {
    float last_x = -1.0e9F;
    for (const TimelineBands::Mark& mark : bands.marks()) {
        const float x = scale.x(mark.step);
        if (mark.step < scale.first || mark.step > scale.last || x - last_x < 1.0F) {
            continue;
        }
        last_x = x;
        const float y = scale.rect.y + scale.rect.height * 0.5F;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        draw_mark(list, {x, y}, context.theme.pixels(4), mark.passed, context.theme);
    }
}

/// Ticks where the search has found something.
void draw_matches(Context& context, const Scale& scale) {
    if (!context.viewer.search().is_of(context.document)) {
        return;
    }
    const Theme& theme = context.theme;
    const Rect& r = scale.rect;
    for (const trace::StepId step : context.viewer.search().marks()) {
        if (step >= scale.first && step <= scale.last) {
            const float x = scale.x(step);
            ImGui::GetWindowDrawList()->AddRectFilled(
                {x, r.y}, {x + theme.pixels(1.5F), r.y + r.height * 0.4F}, theme[Tone::selected]
            );
        }
    }
}

void draw_playhead(Context& context, const Scale& scale) {
    const trace::StepId step = context.document.player().step();
    if (step < scale.first || step > scale.last) {
        return;
    }
    const Theme& theme = context.theme;
    const float x = scale.x(step);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(
        {x - theme.pixels(1), scale.rect.y - theme.pixels(3)},
        {x + theme.pixels(1), scale.rect.bottom() + theme.pixels(2)},
        theme[Tone::accent]
    );
    list.AddTriangleFilled(
        {x - theme.pixels(4), scale.rect.y - theme.pixels(4)},
        {x + theme.pixels(4), scale.rect.y - theme.pixels(4)},
        {x, scale.rect.y + theme.pixels(2)},
        theme[Tone::accent]
    );
}

void scrub(Context& context, const char* id, const Scale& scale) {
    ImGui::SetCursorScreenPos({scale.rect.x, scale.rect.y});
    ImGui::InvisibleButton(id, {scale.rect.width, scale.rect.height});
    if (ImGui::IsItemActive()) {
        context.state.playing = false;
        context.viewer.seek(scale.step(ImGui::GetIO().MousePos.x));
    }
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) {
        tooltip(fmt::format(
            "#{}  drag to scrub",
            explain::whole(static_cast<std::int64_t>(scale.step(ImGui::GetIO().MousePos.x)))
        ));
    }
}

void draw_row_label(Context& context, const Rect& rect, std::string_view label, float width) {
    ImFont* font = context.theme.fonts.small;
    draw_text(
        *ImGui::GetWindowDrawList(),
        font,
        {rect.x - width, rect.y + (rect.height - font->FontSize) * 0.5F},
        context.theme[Tone::quiet],
        shorten(font, label, width - context.theme.units(1))
    );
}

/// A button drawn as shapes: bars and triangles, so that no font needs transport signs.
struct Transport {
    Command command;
    int arrows; ///< how many
    bool back;  ///< pointing left
    bool bar;   ///< with a bar at the tip
};

bool transport_button(Context& context, const Transport& t) {
    const Theme& theme = context.theme;
    const CommandInfo& info = command_info(t.command);
    const std::string why = context.viewer.why_not(t.command);
    const float height = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = theme.units(9);
    ImGui::PushID(static_cast<int>(t.command));
    const bool clicked = ImGui::InvisibleButton("transport", {width, height});
    const bool hovered = ImGui::IsItemHovered();
    tooltip(why.empty() ? fmt::format("{} ({})", info.name, to_string(info.key)) : why);
    ImGui::PopID();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Tone ground = hovered && why.empty() ? Tone::hovered : Tone::raised;
    list.AddRectFilled(at, {at.x + width, at.y + height}, theme[ground], theme.pixels(3));
    const ImU32 color = why.empty() ? theme[Tone::text] : theme.faded(Tone::quiet, 0.5F);
    const float size = theme.pixels(5);
    const float bar = t.bar ? theme.pixels(4) : 0.0F;
    const float total = static_cast<float>(t.arrows) * size * 1.6F + bar;
    const float middle = at.y + height * 0.5F;
    float x = at.x + (width - total) * 0.5F + (t.bar && t.back ? bar : 0.0F);
    const float start = x;
    for (int i = 0; i < t.arrows; ++i) {
        const float tip = t.back ? x : x + size * 1.6F;
        const float base = t.back ? x + size * 1.6F : x;
        // Clockwise, as ImGui's smoothing of edges wants it
        const float top = t.back ? middle + size : middle - size;
        const float bottom = t.back ? middle - size : middle + size;
        list.AddTriangleFilled({base, top}, {tip, middle}, {base, bottom}, color);
        x += size * 1.6F;
    }
    if (t.bar) {
        const float bx = t.back ? start - bar : x + theme.pixels(1);
        list.AddRectFilled({bx, middle - size}, {bx + theme.pixels(2.5F), middle + size}, color);
    }
    return clicked && why.empty();
}

void draw_transport(Context& context) {
    constexpr std::array before{
        Transport{Command::go_start, 1, true, true},
        Transport{Command::triangle_back, 2, true, false},
        Transport{Command::step_back, 1, true, false}};
    constexpr std::array after{
        Transport{Command::step_forward, 1, false, false},
        Transport{Command::triangle_forward, 2, false, false},
        Transport{Command::go_end, 1, false, true}};
    for (const auto& group : {before, after}) {
        for (const Transport& transport : group) {
            if (transport_button(context, transport)) {
                context.viewer.run(transport.command);
            }
            ImGui::SameLine(0.0F, context.theme.units(1));
        }
    }
    const bool playing = context.state.playing;
    const std::string why = context.viewer.why_not(Command::play);
    if (button(context.theme, playing ? "pause" : "play", "play and pause (Space)", why)) {
        context.viewer.run(Command::play);
    }
}

void draw_granularity(Context& context) {
    const Theme& theme = context.theme;
    ImGui::SameLine(0.0F, theme.units(5));
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, theme[Tone::quiet]);
    ImGui::TextUnformatted("step by");
    ImGui::PopStyleColor();
    ImGui::SameLine();
    std::vector<Segment> list;
    for (const Named<trace::Granularity>& row : names<trace::Granularity>()) {
        list.push_back({row.name, row.explanation, ""});
    }
    const int clicked =
        segments(theme, "granularity", list, static_cast<int>(context.state.granularity));
    if (clicked >= 0) {
        context.state.granularity = static_cast<trace::Granularity>(clicked);
    }
}

/// Right of the buttons: the flat number, which any step can be found by.
void draw_number(Context& context, const Rect& rect, float y) {
    const Theme& theme = context.theme;
    const trace::Player& player = context.document.player();
    const std::string number = "#" + explain::whole(static_cast<std::int64_t>(player.step()));
    const std::string of_all =
        fmt::format("{} of {}", number, explain::whole(static_cast<std::int64_t>(player.end())));
    ImFont* font = theme.fonts.mono;
    const float from = ImGui::GetItemRectMax().x + theme.units(3);
    const float right = rect.right() - theme.units(3);
    const std::string shown = fitting(font, {of_all, number, ""}, right - from);
    const float x = right - text_size(font, shown).x;
    const float down = (ImGui::GetFrameHeight() - font->FontSize) * 0.5F;
    draw_text(*ImGui::GetWindowDrawList(), font, {x, y + down}, theme[Tone::text], shown);
}

} // namespace

void draw_timeline(Context& context, const Rect& rect, TimelineBands& bands) {
    const Theme& theme = context.theme;
    begin_panel("timeline", rect, theme, false);
    const float label_width = theme.units(26);
    const float pad = theme.units(3);
    const float row_height = theme.units(6);
    const float x = rect.x + pad + label_width;
    const float width = rect.width - label_width - 2.0F * pad;
    const float y = rect.y + theme.units(3);
    const float gap = theme.units(2);
    const Rect frame{x, y, width, row_height};
    const Rect unit{x, y + row_height + gap, width, row_height};
    const bool open = context.document.is_open();
    draw_row_label(context, frame, "frame", label_width);
    if (open) {
        bands.update(context.document, context.state.selected);
        const Scale whole{frame, 0, context.document.player().end()};
        scrub(context, "frame", whole);
        draw_bands(context, whole, bands.frame());
        draw_matches(context, whole);
        draw_marks(context, whole, bands);
        draw_playhead(context, whole);
    } else {
        draw_bands(context, {frame, 0, 1}, {});
    }
    if (open && !bands.unit().empty()) {
        const Scale lens{unit, bands.unit_range().first, bands.unit_range().last};
        draw_row_label(context, unit, bands.unit_range().label, label_width);
        scrub(context, "unit", lens);
        draw_bands(context, lens, bands.unit());
        draw_matches(context, lens);
        draw_marks(context, lens, bands);
        draw_playhead(context, lens);
    } else {
        draw_row_label(context, unit, "triangle", label_width);
        draw_bands(context, {unit, 0, 1}, {});
        draw_text(
            *ImGui::GetWindowDrawList(),
            theme.fonts.small,
            {unit.x + theme.units(1), unit.y + theme.units(1)},
            theme[Tone::quiet],
            "the steps of one triangle, once the playhead stands in it"
        );
    }
    const float buttons = unit.bottom() + theme.units(3);
    ImGui::SetCursorScreenPos({rect.x + pad, buttons});
    draw_transport(context);
    draw_granularity(context);
    if (open) {
        draw_number(context, rect, buttons);
    }
    end_panel();
}

} // namespace hs::viewer
