#include "app/viewer/traversal_overlay.hpp"

#include "app/viewer/screen_overlay.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>
#include <glm/vec2.hpp>

#include <array>
#include <cmath>
#include <cstdlib>

namespace hs::viewer {
namespace {

constexpr float path_zoom = 8.0F;   ///< window pixels per image pixel from which a path can be seen
constexpr float label_zoom = 20.0F; ///< from which numbers find room
constexpr std::array edge_names{"E01", "E12", "E20"};

/// The drawing under way: where image positions fall.
struct Sheet {
    ImDrawList& list;
    const Theme& theme;
    ImVec2 origin;
    float zoom = 1.0F;

    [[nodiscard]] ImVec2 at(double x, double y) const {
        return {origin.x + static_cast<float>(x) * zoom, origin.y + static_cast<float>(y) * zoom};
    }
    [[nodiscard]] ImVec2 center(PixelPos p) const { return at(p.x + 0.5, p.y + 0.5); }
};

Tone tone_of(raster::TileVerdict verdict) {
    switch (verdict) {
    case raster::TileVerdict::rejected: return Tone::fail;
    case raster::TileVerdict::accepted: return Tone::pass;
    case raster::TileVerdict::partial: return Tone::outline;
    }
    return Tone::outline;
}

/// Rejected tiles are crossed out, so that color is not all that tells verdicts apart.
void draw_tile(const Sheet& sheet, const raster::TileTest& tile, bool current) {
    const Tone tone = tone_of(tile.verdict);
    const ImVec2 a = sheet.at(tile.pixels.x0, tile.pixels.y0);
    const ImVec2 b = sheet.at(tile.pixels.x1, tile.pixels.y1);
    const bool decided = tile.verdict != raster::TileVerdict::partial;
    const float width = sheet.theme.pixels(current ? 3.0F : 1.5F);
    if (decided) {
        sheet.list.AddRectFilled(a, b, sheet.theme.faded(tone, 0.22F));
    }
    sheet.list.AddRect(a, b, sheet.theme[tone], 0.0F, 0, width);
    if (tile.verdict == raster::TileVerdict::rejected) {
        sheet.list.AddLine(a, b, sheet.theme.faded(tone, 0.8F), sheet.theme.pixels(1));
    }
}

/// The way from visit to visit: solid to a neighbor, faint where it jumps.
void draw_path(const Sheet& sheet, const std::vector<trace::TrailVisit>& visits) {
    const float thickness = sheet.theme.pixels(1.5F);
    for (std::size_t i = 1; i < visits.size(); ++i) {
        const PixelPos from = visits[i - 1].pixel;
        const PixelPos to = visits[i].pixel;
        const bool neighbor = std::abs(from.x - to.x) + std::abs(from.y - to.y) <= 1;
        sheet.list.AddLine(
            sheet.center(from),
            sheet.center(to),
            sheet.theme.faded(Tone::outline, neighbor ? 0.9F : 0.3F),
            neighbor ? thickness : sheet.theme.pixels(1)
        );
    }
    const float radius = std::min(sheet.zoom * 0.18F, sheet.theme.pixels(4));
    for (const trace::TrailVisit& visit : visits) {
        if (visit.samples_asked > 0 || visit.samples != 0) {
            continue; // its samples are marked one by one
        }
        const ImVec2 c = sheet.center(visit.pixel);
        if (visit.covered) {
            sheet.list.AddCircleFilled(c, radius, sheet.theme[Tone::pass], 12);
        } else {
            sheet.list.AddCircle(c, radius, sheet.theme[Tone::fail], 12, sheet.theme.pixels(1.25F));
        }
    }
}

/// Where a scanline runs, from the pixel centers.
glm::dvec2 offset_of(const raster::ScanPlace& place) {
    return {
        static_cast<double>(place.offset.x) / subpixel_scale,
        static_cast<double>(place.offset.y) / subpixel_scale};
}

/// A span: a bar over its pixels, ticks where the two edges cross the scanline.
void draw_span(const Sheet& sheet, const raster::Span& span, bool current) {
    const float thickness = sheet.theme.pixels(current ? 3.0F : 1.5F);
    const glm::dvec2 offset = offset_of(span.place);
    const double y = span.row + 0.5 + offset.y;
    if (span.width() > 0) {
        sheet.list.AddLine(
            sheet.at(span.first, y), sheet.at(span.end, y), sheet.theme[Tone::pass], thickness
        );
    }
    const double half_tick = span.place.sample < 0 ? 0.35 : 0.1;
    for (const raster::ScanEdge* edge : {&span.left, &span.right}) {
        const double x = edge->position() + 0.5 + offset.x;
        sheet.list.AddLine(
            sheet.at(x, y - half_tick),
            sheet.at(x, y + half_tick),
            sheet.theme[Tone::outline],
            thickness
        );
    }
}

/// An active edge's x on its scanline, and what it adds per scanline.
void label_edge(
    const Sheet& sheet, const raster::ScanEdge& edge, int row, const raster::ScanPlace& place
) {
    const glm::dvec2 at{edge.position() + 0.5 + offset_of(place).x, row + 0.5 + offset_of(place).y};
    ImFont* font = sheet.theme.fonts.small_mono;
    const std::string text = fmt::format(
        "{} x = {}, {} a row",
        edge_names[static_cast<unsigned>(edge.edge)],
        explain::number(static_cast<float>(at.x)),
        explain::signed_number(static_cast<float>(edge.slope()))
    );
    const ImVec2 size = text_size(font, text);
    const ImVec2 cross = sheet.at(at.x, at.y);
    const float gap = sheet.theme.units(2);
    const float x = edge.left ? cross.x - gap - size.x : cross.x + gap;
    const ImVec2 min{x, cross.y - size.y * 0.5F};
    const float pad = sheet.theme.pixels(3);
    sheet.list.AddRectFilled(
        {min.x - pad, min.y},
        {min.x + size.x + pad, min.y + size.y},
        sheet.theme.faded(Tone::halo, 0.85F),
        sheet.theme.pixels(3)
    );
    draw_text(sheet.list, font, min, sheet.theme[Tone::outline], text);
}

void label_scanline(Context& context, const Sheet& sheet) {
    const trace::Step& step = context.document.player().current();
    const auto& traversal = context.document.player().detail().traversal;
    if (!step.of_scanline() || !traversal || sheet.zoom < label_zoom) {
        return;
    }
    if (traversal->active && step.kind == trace::StepKind::active_edges) {
        const raster::ActiveEdges& active = *traversal->active;
        for (int i = 0; i < active.count; ++i) {
            label_edge(sheet, active.edges[static_cast<unsigned>(i)], active.row, active.place);
        }
    } else if (traversal->span) {
        const raster::Span& span = *traversal->span;
        label_edge(sheet, span.left, span.row, span.place);
        label_edge(sheet, span.right, span.row, span.place);
    }
}

} // namespace

void draw_traversal(Context& context) {
    const trace::Trail& trail = context.document.trail();
    const ScreenView& view = context.state.screen;
    const Sheet sheet{*ImGui::GetWindowDrawList(), context.theme, image_origin(view), view.zoom};
    const trace::Step& step = context.document.player().current();
    for (const raster::TileTest& tile : trail.tiles) {
        const bool current = step.kind == trace::StepKind::tile_test && tile.origin == step.pixel &&
                             tile.size == step.tile_size;
        draw_tile(sheet, tile, current);
    }
    for (const raster::Span& span : trail.spans) {
        const bool current =
            step.of_scanline() && span.row == step.pixel.y && span.place.sample == step.sample;
        draw_span(sheet, span, current);
    }
    if (view.zoom >= path_zoom) {
        draw_path(sheet, trail.visits);
    }
    label_scanline(context, sheet);
}

} // namespace hs::viewer
