#include "app/viewer/sweep_views.hpp"

#include "app/viewer/formula_view.hpp"
#include "app/viewer/screen_colors.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"
#include "core/explain/sweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace hs::viewer {
namespace {

using trace::SweepDetail;
using visibility::SweepEvent;
using visibility::SweepEventKind;

constexpr std::size_t most_rows = 100; ///< of a list

std::string decimal(double value) {
    return explain::number(static_cast<float>(value));
}

/// How often each kind of decision was made: now, of the frame.
void draw_counts(Context& context) {
    const Theme& theme = context.theme;
    const trace::SweepCounts now = context.document.player().counters().sweeps;
    const trace::SweepCounts& all = context.document.recording().counters.sweeps;
    for (const Named<SweepEventKind>& kind : names<SweepEventKind>()) {
        const auto i = static_cast<std::size_t>(kind.value);
        if (all[i] > 0) {
            row(theme, kind.name, fmt::format("{} of {}", now[i], all[i]));
        }
    }
}

/// One line of a list: a swatch in the polygon's color, a name, a number at the right.
struct SweepRow {
    std::int32_t polygon = -1;
    std::string name;
    std::string value;
    Tone tone = Tone::text;
    bool lit = false; ///< what the current decision looks at
};

void draw_sweep_row(const Context& context, const SweepRow& row) {
    const Theme& theme = context.theme;
    const UseFont use{theme.fonts.small_mono};
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = ImGui::GetTextLineHeight() + theme.units(1);
    ImGui::Dummy({width, height});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{start.x + width, start.y + height};
    if (row.lit) {
        list.AddRectFilled(start, end, theme.faded(Tone::accent, 0.22F));
    }
    const float swatch = theme.units(2);
    if (row.polygon >= 0) {
        list.AddRectFilled(
            {start.x + theme.pixels(2), start.y + 0.5F * (height - swatch)},
            {start.x + theme.pixels(2) + swatch, start.y + 0.5F * (height + swatch)},
            swept_color(context.document.recording(), row.polygon)
        );
    }
    const float x = start.x + swatch + theme.units(2);
    const float y = start.y + theme.units(0.5F);
    const float value_width = text_size(theme.fonts.small_mono, row.value).x;
    const float room = width - swatch - value_width - theme.units(4);
    const std::string name = shorten(theme.fonts.small_mono, row.name, room);
    draw_text(list, theme.fonts.small_mono, {x, y}, theme[row.tone], name);
    draw_text(
        list,
        theme.fonts.small_mono,
        {end.x - value_width - theme.units(1), y},
        theme[row.tone],
        row.value
    );
}

void draw_rows(const Context& context, const std::vector<SweepRow>& rows) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.0F});
    for (std::size_t i = 0; i < std::min(rows.size(), most_rows); ++i) {
        draw_sweep_row(context, rows[i]);
    }
    ImGui::PopStyleVar();
    if (rows.size() > most_rows) {
        caption(context.theme, fmt::format("and {} more", rows.size() - most_rows));
    }
}

std::string name_or_background(const trace::Recording& recording, std::int32_t polygon) {
    return polygon < 0 ? "background" : explain::swept_name(recording, polygon);
}

// ---- scanlines

void draw_edges(const Context& context, const SweepDetail& detail) {
    const Theme& theme = context.theme;
    const trace::Recording& recording = context.document.recording();
    const visibility::ScanState& state = *detail.scan;
    const visibility::ScanScene& scene = *state.scene;
    std::vector<std::string> bucket;
    for (const std::int32_t edge : scene.table.bucket(detail.row)) {
        bucket.push_back(explain::edge_label(recording, scene, edge));
    }
    row(theme,
        "edge table",
        bucket.empty() ? std::string{"no edge begins here"}
                       : fmt::format("{} begin here", fmt::join(bucket, " ")));
    heading(theme, "Active edges, x");
    std::vector<SweepRow> rows;
    for (const visibility::ActiveScanEdge& active : state.active) {
        const std::int32_t polygon = scene.table.edge(active.edge).polygon;
        rows.push_back(
            {.polygon = polygon,
             .name = fmt::format(
                 "{}  of {}",
                 explain::edge_label(recording, scene, active.edge),
                 explain::swept_name(recording, polygon)
             ),
             .value = decimal(active.x),
             .lit = active.edge == detail.last().edge}
        );
    }
    if (rows.empty()) {
        caption(theme, "None crosses this scanline.");
    }
    draw_rows(context, rows);
}

/// Polygons of this scanline with their flags; depths where it is inside.
void draw_polygon_table(const Context& context, const SweepDetail& detail) {
    const visibility::ScanState& state = *detail.scan;
    const trace::Recording& recording = context.document.recording();
    std::set<std::int32_t> polygons;
    for (const visibility::ActiveScanEdge& active : state.active) {
        polygons.insert(state.scene->table.edge(active.edge).polygon);
    }
    if (polygons.empty()) {
        return;
    }
    heading(context.theme, "Polygon table: flag, depth");
    const SweepEvent& last = detail.last();
    std::vector<SweepRow> rows;
    for (const std::int32_t polygon : polygons) {
        const bool in = state.in[static_cast<std::size_t>(polygon)];
        rows.push_back(
            {.polygon = polygon,
             .name = explain::swept_name(recording, polygon),
             .value =
                 in ? fmt::format("in  {}", decimal(visibility::scan_depth(state, polygon, last.x)))
                    : "out",
             .tone = in ? Tone::text : Tone::quiet,
             .lit = polygon == last.polygon || polygon == last.other}
        );
    }
    draw_rows(context, rows);
    std::vector<std::string> inside;
    for (const std::int32_t polygon : state.inside) {
        inside.push_back(explain::swept_label(recording, polygon));
    }
    row(context.theme,
        "inside",
        inside.empty() ? std::string{"–"} : fmt::format("{}", fmt::join(inside, " ")));
}

void draw_spans(const Context& context, const SweepDetail& detail) {
    std::vector<SweepRow> rows;
    for (const SweepEvent& event : detail.decisions) {
        if (event.kind == SweepEventKind::span) {
            rows.push_back(
                {.polygon = event.polygon,
                 .name = name_or_background(context.document.recording(), event.polygon),
                 .value = fmt::format("{} … {}", decimal(event.x), decimal(event.x_end)),
                 .tone = event.polygon < 0 ? Tone::quiet : Tone::text}
            );
        }
    }
    if (rows.empty()) {
        return;
    }
    rows.back().lit = detail.last().kind == SweepEventKind::span;
    heading(context.theme, "Spans found");
    draw_rows(context, rows);
}

// ---- a line of depths

/// The line as a strip: who is nearest above, how deep below. Dark is near.
void draw_line_buffer(const Context& context, const SweepDetail& detail) {
    const Theme& theme = context.theme;
    const trace::Recording& recording = context.document.recording();
    const visibility::LineBuffer& line = *detail.line;
    heading(theme, "The line: polygon, depth");
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = theme.units(5);
    const float cell = width / static_cast<float>(line.depth.size());
    ImGui::Dummy({width, 2.0F * height + theme.units(2)});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < line.depth.size(); ++i) {
        const float x = start.x + cell * static_cast<float>(i);
        const ImVec2 min{x, start.y};
        const ImVec2 middle{x + std::max(cell, 1.0F), start.y + height};
        if (line.polygon[i] < 0) {
            list.AddRectFilled(min, {middle.x, middle.y + height}, theme.faded(Tone::canvas, 1.0F));
            continue;
        }
        const double depth = std::clamp(line.depth[i], 0.0, 1.0);
        const auto gray = static_cast<int>(255.0 * depth);
        list.AddRectFilled(min, middle, swept_color(recording, line.polygon[i]));
        list.AddRectFilled(
            {x, middle.y}, {middle.x, middle.y + height}, IM_COL32(gray, gray, gray, 255)
        );
    }
    const ImVec2 end{start.x + width, start.y + 2.0F * height};
    list.AddRect(start, end, theme[Tone::hairline]);
    const SweepEvent& last = detail.last();
    if (last.kind == SweepEventKind::depth || last.kind == SweepEventKind::enter) {
        const double cells = last.kind == SweepEventKind::depth ? 1.0 : last.x_end - last.x;
        const float x = start.x + cell * static_cast<float>(last.x);
        list.AddRect(
            {x, start.y},
            {x + cell * static_cast<float>(cells), end.y},
            theme[Tone::accent],
            0.0F,
            0,
            theme.pixels(2)
        );
    }
}

// ---- rays

void draw_ray(const Context& context, const SweepDetail& detail) {
    const Theme& theme = context.theme;
    const trace::Recording& recording = context.document.recording();
    const visibility::RayCast& cast = *detail.ray;
    const auto point = [](const glm::dvec3& p) {
        return explain::point(
            static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)
        );
    };
    row(theme, "from", point(cast.ray.origin));
    row(theme, "to", point(cast.ray.origin + cast.ray.direction));
    std::vector<SweepRow> hits;
    std::size_t asked = 0;
    for (const SweepEvent& event : detail.decisions) {
        asked += event.kind == SweepEventKind::meet ? 1U : 0U;
        if (event.kind == SweepEventKind::meet && event.verdict) {
            const bool nearest = event.polygon == cast.nearest;
            hits.push_back(
                {.polygon = event.polygon,
                 .name = explain::swept_name(recording, event.polygon),
                 .value = fmt::format("{}{}", nearest ? "nearest  " : "", decimal(event.value)),
                 .tone = nearest ? Tone::text : Tone::quiet,
                 .lit = event.polygon == detail.last().polygon}
            );
        }
    }
    row(theme,
        "asked",
        fmt::format("{} of {} triangles", asked, recording.order.sweep->triangles.size()));
    heading(theme, "Hits, t");
    if (hits.empty()) {
        caption(theme, "None so far.");
    }
    draw_rows(context, hits);
}

void draw_formulas(Context& context, const SweepDetail& detail) {
    if (context.document.player().current().kind != trace::StepKind::sweep) {
        return;
    }
    ImGui::Dummy({0.0F, context.theme.units(1)});
    for (const explain::Formula& formula :
         explain::sweep_formulas(context.document.recording(), detail)) {
        draw_formula(context, formula, true);
    }
}

} // namespace

ImU32 swept_color(const trace::Recording& recording, std::int32_t polygon) {
    const pipeline::PieceName& piece = recording.order.sweep->polygon(polygon);
    return triangle_color(recording.objects[piece.object].first_triangle + piece.triangle);
}

void draw_sweep(Context& context) {
    const Theme& theme = context.theme;
    const trace::Recording& recording = context.document.recording();
    heading(theme, fmt::format("{}: now, of the frame", name_of(recording.settings().visibility)));
    draw_counts(context);
    const SweepDetail* detail = context.document.sweep_detail();
    if (detail == nullptr) {
        caption(theme, "Step on to the rows of the image to see what is decided in each.");
        return;
    }
    if (detail->ray) {
        heading(theme, fmt::format("Ray through pixel {}", explain::pixel(detail->pixel)));
        draw_ray(context, *detail);
    } else if (detail->scan) {
        heading(theme, fmt::format("Scanline {}", detail->row));
        if (detail->line) {
            draw_line_buffer(context, *detail);
        }
        draw_edges(context, *detail);
        if (!detail->line) {
            draw_polygon_table(context, *detail);
            draw_spans(context, *detail);
        }
    }
    draw_formulas(context, *detail);
}

} // namespace hs::viewer
