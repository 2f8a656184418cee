#include "app/viewer/sweep_overlay.hpp"

#include "app/viewer/screen_overlay.hpp"
#include "app/viewer/sweep_views.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace hs::viewer {
namespace {

using trace::SweepDetail;
using visibility::SweepEvent;
using visibility::SweepEventKind;

/// The drawing under way: where image positions fall.
struct Sheet {
    ImDrawList& list;
    const Theme& theme;
    const trace::Recording& recording;
    ImVec2 origin;
    float zoom = 1.0F;

    [[nodiscard]] ImVec2 at(double x, double y) const {
        return {origin.x + static_cast<float>(x) * zoom, origin.y + static_cast<float>(y) * zoom};
    }
};

using Outline = std::array<glm::dvec2, 3>;

/// Where a polygon of the sweep is seen; nothing where some of it lies behind the eye.
std::optional<Outline>
outline_of(const Sheet& sheet, const SweepDetail& detail, std::int32_t polygon) {
    Outline outline;
    if (detail.scan) {
        const auto& corners =
            detail.scan->scene->polygons[static_cast<std::size_t>(polygon)].corners;
        for (unsigned k = 0; k < 3; ++k) {
            outline[k] = glm::dvec2{corners[k].position};
        }
        return outline;
    }
    const pipeline::PieceName& name = sheet.recording.order.sweep->polygon(polygon);
    const pipeline::DrawCall& call = sheet.recording.frame->calls()[name.object];
    for (int k = 0; k < 3; ++k) {
        const pipeline::ShadedVertex& vertex = call.vertices[call.triangles()[name.triangle][k]];
        if (vertex.clip.w <= 0.0F) {
            return std::nullopt;
        }
        outline[static_cast<unsigned>(k)] =
            glm::dvec2{glm::vec2{vertex.window.window.x, vertex.window.window.y}};
    }
    return outline;
}

void draw_outline(const Sheet& sheet, const Outline& outline, Tone tone) {
    std::array<ImVec2, 3> corners;
    for (unsigned k = 0; k < 3; ++k) {
        corners[k] = sheet.at(outline[k].x, outline[k].y);
    }
    const auto count = static_cast<int>(corners.size());
    const float width = sheet.theme.pixels(2);
    const ImU32 halo = sheet.theme.faded(Tone::halo, 0.7F);
    sheet.list.AddPolyline(corners.data(), count, halo, ImDrawFlags_Closed, 2.0F * width);
    sheet.list.AddPolyline(corners.data(), count, sheet.theme[tone], ImDrawFlags_Closed, width);
}

/// The polygons of the decision: the one asked about, and the one it is compared with.
void draw_polygons(const Sheet& sheet, const SweepDetail& detail) {
    const SweepEvent& last = detail.last();
    if (last.other >= 0) {
        if (const auto outline = outline_of(sheet, detail, last.other)) {
            draw_outline(sheet, *outline, Tone::outline);
        }
    }
    if (last.polygon >= 0) {
        if (const auto outline = outline_of(sheet, detail, last.polygon)) {
            draw_outline(sheet, *outline, Tone::accent);
        }
    }
}

/// The scanline through the pixel centers, thick where a span has been found.
void draw_spans(const Sheet& sheet, const SweepDetail& detail) {
    const double y = visibility::scanline(detail.row);
    const ImVec2 left = sheet.at(0.0, y);
    const ImVec2 right = sheet.at(sheet.recording.width(), y);
    const ImU32 halo = sheet.theme.faded(Tone::halo, 0.8F);
    sheet.list.AddLine(left, right, halo, sheet.theme.pixels(3));
    sheet.list.AddLine(left, right, sheet.theme[Tone::selected], sheet.theme.pixels(1));
    const float thick = std::clamp(0.4F * sheet.zoom, sheet.theme.pixels(3), sheet.theme.pixels(9));
    const auto span = [&](std::int32_t polygon, double x, double x_end) {
        if (polygon < 0) {
            return;
        }
        const ImVec2 a = sheet.at(x, y);
        const ImVec2 b = sheet.at(x_end, y);
        const float border = sheet.theme.pixels(1.5F);
        sheet.list.AddRectFilled(
            {a.x, a.y - 0.5F * thick - border}, {b.x, b.y + 0.5F * thick + border}, halo
        );
        sheet.list.AddRectFilled(
            {a.x, a.y - 0.5F * thick},
            {b.x, b.y + 0.5F * thick},
            swept_color(sheet.recording, polygon)
        );
    };
    for (const SweepEvent& event : detail.decisions) {
        if (event.kind == SweepEventKind::span) {
            span(event.polygon, event.x, event.x_end);
        }
    }
    if (detail.line) {
        for (const visibility::PixelSpan& found : visibility::visible_spans(*detail.line)) {
            span(found.polygon, found.x, found.x_end);
        }
    }
}

/// Active edges as dots; the place of the decision as a tick.
void draw_places(const Sheet& sheet, const SweepDetail& detail) {
    const double y = visibility::scanline(detail.row);
    const float radius = sheet.theme.pixels(3);
    for (const visibility::ActiveScanEdge& active : detail.scan->active) {
        const ImVec2 at = sheet.at(active.x, y);
        sheet.list.AddCircleFilled(at, radius + sheet.theme.pixels(1), sheet.theme[Tone::halo]);
        sheet.list.AddCircleFilled(at, radius, sheet.theme[Tone::selected]);
    }
    const SweepEvent& last = detail.last();
    const bool placed = last.edge >= 0 || last.kind == SweepEventKind::compare ||
                        last.kind == SweepEventKind::false_edge;
    if (placed) {
        const ImVec2 at = sheet.at(last.x, y);
        const float reach = std::max(0.7F * sheet.zoom, sheet.theme.pixels(7));
        sheet.list.AddLine(
            {at.x, at.y - reach},
            {at.x, at.y + reach},
            sheet.theme[Tone::halo],
            sheet.theme.pixels(4)
        );
        sheet.list.AddLine(
            {at.x, at.y - reach},
            {at.x, at.y + reach},
            sheet.theme[Tone::accent],
            sheet.theme.pixels(2)
        );
    }
}

void frame_pixel(const Sheet& sheet, PixelPos pixel) {
    sheet.list.AddRect(
        sheet.at(pixel.x, pixel.y),
        sheet.at(pixel.x + 1, pixel.y + 1),
        sheet.theme[Tone::accent],
        0.0F,
        0,
        sheet.theme.pixels(2)
    );
}

} // namespace

void draw_swept_row(Context& context) {
    const SweepDetail* detail = context.document.sweep_detail();
    if (detail == nullptr || detail->decisions.empty()) {
        return;
    }
    const Sheet sheet{
        *ImGui::GetWindowDrawList(),
        context.theme,
        context.document.recording(),
        image_origin(context.state.screen),
        context.state.screen.zoom};
    const trace::Step& step = context.document.player().current();
    const bool deciding = step.kind == trace::StepKind::sweep;
    if (deciding) {
        draw_polygons(sheet, *detail);
    }
    if (detail->scan) {
        draw_spans(sheet, *detail);
        draw_places(sheet, *detail);
    }
    if (deciding && step.sweeps_pixel()) {
        frame_pixel(sheet, step.pixel);
    }
}

} // namespace hs::viewer
