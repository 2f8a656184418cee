// Cost: what the traversal has spent so far, and what every traversal would spend on the triangle.
#include "app/viewer/cost_visibility.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace hs::viewer {
namespace {

using trace::TraversalCost;

double per_fragment(std::uint64_t count, std::uint64_t fragments) {
    return fragments == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(fragments);
}

/// Counts up to the playhead beside those of the whole frame.
void draw_counts(Context& context) {
    const Theme& theme = context.theme;
    const trace::Counters now = context.document.player().counters();
    const trace::Counters& all = context.document.recording().counters;
    const raster::Cost& a = now.traversal;
    const raster::Cost& b = all.traversal;
    const std::string traversal{name_of(context.document.settings().traversal)};
    heading(theme, fmt::format("Spent by {}: now, of the frame", traversal));
    const auto line = [&theme](const char* label, std::uint64_t part, std::uint64_t whole) {
        row(theme, label, fmt::format("{} of {}", part, whole));
    };
    line("pixels visited", a.pixels, b.pixels);
    line("tiles tested", a.tiles, b.tiles);
    line("evaluations", a.evaluations, b.evaluations);
    line("multiplied", a.multiplications(), b.multiplications());
    line("added", a.additions(), b.additions());
    line("divided", a.divisions, b.divisions);
    line("covered", now.fragments, all.fragments);
    row(theme,
        "per covered",
        fmt::format(
            "{:.2f}, frame {:.2f}",
            per_fragment(a.pixels, now.fragments),
            per_fragment(b.pixels, all.fragments)
        ));
}

/// One traversal's bar and numbers; a click chooses it.
void draw_traversal_row(
    Context& context, const TraversalCost& cost, std::uint64_t most, bool chosen
) {
    const Theme& theme = context.theme;
    const std::string name{name_of(cost.traversal)};
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const UseFont use{theme.fonts.small_mono};
    const float line = ImGui::GetTextLineHeight();
    const float height = 3.0F * line + theme.units(2);
    ImGui::PushID(name.c_str());
    if (ImGui::InvisibleButton("choose", {width, height})) {
        scene::Settings settings = context.document.recording().settings();
        settings.traversal = cost.traversal;
        context.viewer.change_settings(settings);
    }
    tooltip("Record the frame with this traversal");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (chosen || ImGui::IsItemHovered()) {
        list.AddRectFilled(
            start,
            {start.x + width, start.y + height},
            theme.faded(Tone::accent, chosen ? 0.25F : 0.12F),
            theme.pixels(3)
        );
    }
    const std::uint64_t work = cost.cost.multiplications() + cost.cost.additions();
    const float share = most == 0 ? 0.0F : static_cast<float>(work) / static_cast<float>(most);
    const float bar = theme.pixels(3);
    list.AddRectFilled(
        {start.x, start.y + height - bar},
        {start.x + width * share, start.y + height},
        theme[chosen ? Tone::accent : Tone::quiet]
    );
    const float indent = theme.units(1);
    draw_text(list, theme.fonts.small_mono, {start.x + indent, start.y}, theme[Tone::text], name);
    const std::string visits = fmt::format(
        "{} px{}, {:.2f} per covered",
        cost.cost.pixels,
        cost.cost.tiles > 0 ? fmt::format(" + {} tiles", cost.cost.tiles) : "",
        per_fragment(cost.cost.pixels, cost.fragments)
    );
    draw_text(
        list, theme.fonts.small_mono, {start.x + indent, start.y + line}, theme[Tone::quiet], visits
    );
    const std::string arithmetic = fmt::format(
        "{} ×  {} +  {} ÷", cost.cost.multiplications(), cost.cost.additions(), cost.cost.divisions
    );
    draw_text(
        list,
        theme.fonts.small_mono,
        {start.x + indent, start.y + 2.0F * line},
        theme[Tone::quiet],
        arithmetic
    );
    ImGui::PopID();
}

void draw_comparison(Context& context) {
    const Theme& theme = context.theme;
    const auto& costs = context.document.traversal_costs();
    if (costs.empty()) {
        caption(theme, "Stand on a triangle to see what each traversal would spend on it.");
        return;
    }
    const trace::Step& step = context.document.player().current();
    heading(theme, fmt::format("All traversals on triangle {}", step.triangle));
    caption(
        theme,
        fmt::format(
            "They cover the same {} pixels. Bars: multiplications and additions.",
            costs.front().fragments
        )
    );
    std::uint64_t most = 0;
    for (const TraversalCost& cost : costs) {
        most = std::max(most, cost.cost.multiplications() + cost.cost.additions());
    }
    const scene::TraversalKind chosen = context.document.settings().traversal;
    for (const TraversalCost& cost : costs) {
        draw_traversal_row(context, cost, most, cost.traversal == chosen);
    }
}

} // namespace

void draw_cost(Context& context) {
    draw_counts(context);
    draw_comparison(context);
    draw_visibility_costs(context);
}

} // namespace hs::viewer
