#include "app/viewer/cost_visibility.hpp"

#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hs::viewer {
namespace {

using trace::VisibilityOutcome;

/// "12 questions, 3 cuts" and what came of it.
std::string work_text(const VisibilityOutcome& outcome) {
    std::string text = fmt::format("{} questions", outcome.questions);
    if (outcome.cuts > 0) {
        text += fmt::format(", {} cuts", outcome.cuts);
    }
    return text + fmt::format(", {} written", outcome.written);
}

std::string picture_text(const VisibilityOutcome& outcome) {
    return outcome.from_z_buffer.pixels == 0
               ? std::string{"the z-buffer's picture"}
               : fmt::format("{} pixels unlike the z-buffer", outcome.from_z_buffer.pixels);
}

/// Bars have a logarithmic length: algorithms differ by powers of ten.
float share_of(std::uint64_t questions, std::uint64_t most) {
    return most == 0 ? 0.0F
                     : static_cast<float>(
                           std::log1p(static_cast<double>(questions)) /
                           std::log1p(static_cast<double>(most))
                       );
}

void draw_outcome(Context& context, const VisibilityOutcome& outcome, std::uint64_t most) {
    const Theme& theme = context.theme;
    const std::string name{name_of(outcome.visibility)};
    if (!outcome.refusal.empty()) {
        small_mono(theme, name, Tone::quiet);
        caption(theme, outcome.refusal);
        return;
    }
    const bool chosen = context.document.recording().settings().visibility == outcome.visibility;
    const UseFont use{theme.fonts.small_mono};
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float line = ImGui::GetTextLineHeight();
    const float height = 3.0F * line + theme.units(2);
    ImGui::PushID(name.c_str());
    if (ImGui::InvisibleButton("choose", {width, height})) {
        scene::Settings settings = context.document.recording().settings();
        settings.visibility = outcome.visibility;
        context.viewer.change_settings(settings);
    }
    tooltip("Record the frame with this algorithm");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{start.x + width, start.y + height};
    if (chosen || ImGui::IsItemHovered()) {
        list.AddRectFilled(
            start, end, theme.faded(Tone::accent, chosen ? 0.25F : 0.12F), theme.pixels(3)
        );
    }
    list.AddRectFilled(
        {start.x, end.y - theme.pixels(3)},
        {start.x + width * share_of(outcome.questions, most), end.y},
        theme[chosen ? Tone::accent : Tone::quiet]
    );
    const float x = start.x + theme.units(1);
    const float room = width - theme.units(2);
    const auto text = [&](float y, Tone tone, const std::string& words) {
        const std::string shown = shorten(theme.fonts.small_mono, words, room);
        draw_text(list, theme.fonts.small_mono, {x, start.y + y}, theme[tone], shown);
    };
    text(0.0F, Tone::text, name);
    text(line, Tone::quiet, work_text(outcome));
    text(2.0F * line, Tone::quiet, picture_text(outcome));
    ImGui::PopID();
}

} // namespace

void draw_visibility_costs(Context& context) {
    const Theme& theme = context.theme;
    heading(theme, "All visible-surface algorithms");
    const auto& outcomes = context.document.visibility_outcomes();
    if (outcomes.empty()) {
        const bool small = context.document.recording().end_step <= Document::most_steps_to_compare;
        if (button(
                theme,
                "compare them",
                "Record this scene with each of them",
                small ? "" : "Too many steps to wait for; halfspace compare --visibility does it"
            )) {
            context.document.compare_visibility();
        }
        return;
    }
    caption(
        theme, "Bars: questions asked, logarithmic. Depth tests of the z-buffer are questions."
    );
    std::uint64_t most = 0;
    for (const VisibilityOutcome& outcome : outcomes) {
        most = std::max(most, outcome.questions);
    }
    for (const VisibilityOutcome& outcome : outcomes) {
        draw_outcome(context, outcome, most);
    }
}

} // namespace hs::viewer
