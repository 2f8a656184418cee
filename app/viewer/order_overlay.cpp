#include "app/viewer/order_overlay.hpp"

#include "app/viewer/layout.hpp"
#include "app/viewer/order_rows.hpp"
#include "app/viewer/screen_overlay.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/geometry/viewport.hpp"

#include <vector>

namespace hs::viewer {
namespace {

/// The drawing under way: where image positions fall.
struct Sheet {
    ImDrawList& list;
    const Theme& theme;
    const Rect& area; ///< names stay within it
    ImVec2 origin;
    float zoom = 1.0F;

    [[nodiscard]] ImVec2 at(const glm::dvec3& p) const {
        return {
            origin.x + static_cast<float>(p.x) * zoom, origin.y + static_cast<float>(p.y) * zoom};
    }
};

using Corners = std::vector<glm::dvec3>;

/// Where a polygon of the world is seen: from its weights, as it will be drawn. Empty if some of it
/// lies behind the eye.
Corners projected(const pipeline::Frame& frame, const visibility::WorldPolygon& polygon) {
    const pipeline::OrderedPolygon whole = pipeline::ordered_polygon(polygon);
    std::uint32_t triangle = whole.triangle;
    Corners corners;
    for (const pipeline::DrawCall& call : frame.calls()) {
        if (triangle >= call.triangles().size()) {
            triangle -= static_cast<std::uint32_t>(call.triangles().size());
            continue;
        }
        const scene::TriangleIndices& indices = call.triangles()[triangle];
        for (const auto& corner : polygon.corners) {
            glm::dvec4 clip{0.0};
            for (int k = 0; k < 3; ++k) {
                clip +=
                    corner.weights[k] * glm::dvec4{math::to_vec4(call.vertices[indices[k]].clip)};
            }
            if (clip.w <= 0.0) {
                return {};
            }
            const auto window = geometry::to_window(
                math::to_position<math::ClipSpace>(glm::vec4{clip}), call.viewport
            );
            corners.emplace_back(glm::vec3{window.window.x, window.window.y, 0.0F});
        }
        return corners;
    }
    return corners;
}

Corners corners_of(Context& context, const trace::OrderDetail& detail, std::int32_t polygon) {
    const auto index = static_cast<std::size_t>(polygon);
    Corners corners;
    if (detail.window_polygons().empty()) {
        return projected(*context.document.recording().frame, detail.world_polygons()[index]);
    }
    for (const auto& corner : detail.window_polygons()[index].corners) {
        corners.push_back(corner.position);
    }
    return corners;
}

void draw_outline(const Sheet& sheet, const Corners& polygon, Tone tone) {
    std::vector<ImVec2> corners;
    for (const glm::dvec3& corner : polygon) {
        corners.push_back(sheet.at(corner));
    }
    const auto closed = static_cast<int>(corners.size());
    sheet.list.AddConvexPolyFilled(corners.data(), closed, sheet.theme.faded(tone, 0.16F));
    const float width = sheet.theme.pixels(2);
    sheet.list.AddPolyline(
        corners.data(),
        closed,
        sheet.theme.faded(Tone::halo, 0.7F),
        ImDrawFlags_Closed,
        2.0F * width
    );
    sheet.list.AddPolyline(corners.data(), closed, sheet.theme[tone], ImDrawFlags_Closed, width);
}

/// The polygon's name in its middle, with ▲ or ▼ where it won or lost.
void draw_label(
    const Sheet& sheet,
    const Corners& polygon,
    const std::string& name,
    const std::optional<bool>& first
) {
    glm::dvec3 middle{0.0};
    for (const glm::dvec3& corner : polygon) {
        middle += corner / static_cast<double>(polygon.size());
    }
    ImFont* const font = sheet.theme.fonts.small;
    const ImVec2 size = text_size(font, name);
    const float pad = sheet.theme.units(1);
    const float mark = first ? sheet.theme.units(3) : 0.0F;
    const ImVec2 center = sheet.at(middle);
    const float width = size.x + mark + 2.0F * pad;
    const float height = size.y + 2.0F * pad;
    const ImVec2 min{
        keep_within(center.x - 0.5F * width, sheet.area.x, sheet.area.right() - width),
        keep_within(center.y - 0.5F * height, sheet.area.y, sheet.area.bottom() - height)};
    const ImVec2 max{min.x + width, min.y + height};
    sheet.list.AddRectFilled(min, max, sheet.theme[Tone::panel], sheet.theme.pixels(3));
    if (first) {
        const float radius = sheet.theme.units(1);
        draw_mark(
            sheet.list, {min.x + pad + radius, min.y + 0.5F * height}, radius, *first, sheet.theme
        );
    }
    draw_text(sheet.list, font, {min.x + pad + mark, min.y + pad}, sheet.theme[Tone::text], name);
}

} // namespace

void draw_ordered_pair(Context& context) {
    if (context.document.player().current().kind != trace::StepKind::order) {
        return;
    }
    const trace::OrderDetail* detail = context.document.order_detail();
    if (detail == nullptr) {
        return;
    }
    const Sheet sheet{
        *ImGui::GetWindowDrawList(),
        context.theme,
        context.state.screen.area,
        image_origin(context.state.screen),
        context.state.screen.zoom};
    const DecidedPair pair = decided_pair(detail->decision);
    for (const bool labels : {false, true}) {
        for (const auto& [index, first] : {pair.second, pair.first}) {
            const Corners polygon = index < 0 ? Corners{} : corners_of(context, *detail, index);
            if (polygon.empty()) {
                continue;
            }
            if (labels) {
                draw_label(sheet, polygon, full_name(context, *detail, index), first);
            } else {
                draw_outline(sheet, polygon, tone_of(first));
            }
        }
    }
}

} // namespace hs::viewer
