#include "app/viewer/order_overlay.hpp"

#include "app/viewer/order_rows.hpp"
#include "app/viewer/screen_overlay.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"

namespace hs::viewer {
namespace {

/// The drawing under way: where image positions fall.
struct Sheet {
    ImDrawList& list;
    const Theme& theme;
    ImVec2 origin;
    float zoom = 1.0F;

    [[nodiscard]] ImVec2 at(const glm::dvec3& p) const {
        return {
            origin.x + static_cast<float>(p.x) * zoom, origin.y + static_cast<float>(p.y) * zoom};
    }
};

void draw_outline(const Sheet& sheet, const visibility::WindowPolygon& polygon, Tone tone) {
    const std::size_t count = polygon.corners.size();
    std::vector<ImVec2> corners;
    for (const auto& corner : polygon.corners) {
        corners.push_back(sheet.at(corner.position));
    }
    const auto closed = static_cast<int>(count);
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
    const visibility::WindowPolygon& polygon,
    const std::string& name,
    const std::optional<bool>& first
) {
    glm::dvec3 middle{0.0};
    for (const auto& corner : polygon.corners) {
        middle += corner.position / static_cast<double>(polygon.corners.size());
    }
    ImFont* const font = sheet.theme.fonts.small;
    const ImVec2 size = text_size(font, name);
    const float pad = sheet.theme.units(1);
    const float mark = first ? sheet.theme.units(3) : 0.0F;
    const ImVec2 center = sheet.at(middle);
    const ImVec2 min{center.x - 0.5F * (size.x + mark) - pad, center.y - 0.5F * size.y - pad};
    const ImVec2 max{center.x + 0.5F * (size.x + mark) + pad, center.y + 0.5F * size.y + pad};
    sheet.list.AddRectFilled(min, max, sheet.theme[Tone::panel], sheet.theme.pixels(3));
    if (first) {
        const float radius = sheet.theme.units(1);
        draw_mark(sheet.list, {min.x + pad + radius, center.y}, radius, *first, sheet.theme);
    }
    draw_text(sheet.list, font, {min.x + pad + mark, min.y + pad}, sheet.theme[Tone::text], name);
}

} // namespace

void draw_ordered_pair(Context& context) {
    if (context.document.player().current().kind != trace::StepKind::order) {
        return;
    }
    const trace::OrderDetail* detail = context.document.order_detail();
    const auto polygons = detail->window_polygons();
    const Sheet sheet{
        *ImGui::GetWindowDrawList(),
        context.theme,
        image_origin(context.state.screen),
        context.state.screen.zoom};
    const DecidedPair pair = decided_pair(detail->decision);
    for (const bool labels : {false, true}) {
        for (const auto& [index, first] : {pair.second, pair.first}) {
            if (index < 0 || polygons.empty()) {
                continue;
            }
            const auto& polygon = polygons[static_cast<std::size_t>(index)];
            if (labels) {
                draw_label(sheet, polygon, short_name(context, *detail, index), first);
            } else {
                draw_outline(sheet, polygon, tone_of(first));
            }
        }
    }
}

} // namespace hs::viewer
