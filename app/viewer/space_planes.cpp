#include "app/viewer/space_planes.hpp"

#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/eye_planes.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace hs::viewer {
namespace {

using explain::PlanesThroughEye;
using explain::PlaneThroughEye;

constexpr std::array edge_names{"E01", "E12", "E20"};
constexpr std::array edge_tones{Tone::vertex_0, Tone::vertex_1, Tone::vertex_2};

// A plane has no end: it fades out beyond the triangle, along the rays and along the edge.
constexpr std::array rays{0.0F, 1.0F, planes_reach}; ///< times the edge's distance from the eye
constexpr std::array along{-0.3F, 0.0F, 1.0F, 1.3F}; ///< from one end of the edge to the other
constexpr std::array strength_on_rays{1.0F, 1.0F, 0.0F};
constexpr std::array strength_along{0.0F, 1.0F, 1.0F, 0.0F};

/// The drawing under way.
struct Sheet {
    ImDrawList& list;
    const Theme& theme;
    const OrbitCamera& camera;
    const SpaceMap& map;

    [[nodiscard]] std::optional<ImVec2> at(const glm::vec3& eye) const {
        const auto place = map.of_eye(eye);
        return place ? camera.project(*place) : std::nullopt;
    }
    void line(const glm::vec3& a, const glm::vec3& b, ImU32 color, float width) const {
        const auto from = map.of_eye(a);
        const auto to = map.of_eye(b);
        if (const auto seen = from && to ? camera.project(*from, *to) : std::nullopt) {
            list.AddLine((*seen)[0], (*seen)[1], color, theme.pixels(width));
        }
    }
};

/// Of a plane, a point on the ray through a point of the edge.
glm::vec3 point_of(const PlaneThroughEye& plane, float t, float s) {
    return (plane.edge[0] + (plane.edge[1] - plane.edge[0]) * t) * s;
}

/// A patch of a plane with a strength of color at every corner; nothing where one is out of sight.
void draw_patch(
    const Sheet& sheet, const PlaneThroughEye& plane, unsigned ray, unsigned edge, Tone tone
) {
    constexpr float strongest = 0.28F;
    constexpr std::array<std::array<unsigned, 2>, 4> around{{{0, 0}, {0, 1}, {1, 1}, {1, 0}}};
    std::array<ImVec2, 4> points{};
    std::array<ImU32, 4> colors{};
    for (unsigned i = 0; i < 4; ++i) {
        const unsigned r = ray + around[i][0];
        const unsigned e = edge + around[i][1];
        const auto point = sheet.at(point_of(plane, along[e], rays[r]));
        if (!point) {
            return;
        }
        points[i] = *point;
        colors[i] = sheet.theme.faded(tone, strongest * strength_on_rays[r] * strength_along[e]);
    }
    ImDrawList& list = sheet.list;
    list.PrimReserve(6, 4);
    const auto first = static_cast<ImDrawIdx>(list._VtxCurrentIdx);
    for (const unsigned corner : {0U, 1U, 2U, 0U, 2U, 3U}) {
        list.PrimWriteIdx(static_cast<ImDrawIdx>(first + corner));
    }
    for (unsigned i = 0; i < 4; ++i) {
        list.PrimWriteVtx(points[i], ImGui::GetFontTexUvWhitePixel(), colors[i]);
    }
}

void draw_plane(const Sheet& sheet, const PlaneThroughEye& plane, Tone tone) {
    for (unsigned ray = 0; ray + 1 < rays.size(); ++ray) {
        for (unsigned edge = 0; edge + 1 < along.size(); ++edge) {
            draw_patch(sheet, plane, ray, edge, tone);
        }
    }
    for (const float end : {0.0F, 1.0F}) {
        sheet.line(
            glm::vec3{0.0F}, point_of(plane, end, rays.back()), sheet.theme.faded(tone, 0.5F), 1.0F
        );
    }
}

/// The normal, from the middle of what is drawn of the plane; its tip tells the side of the ray.
void draw_normal(
    const Sheet& sheet,
    const PlanesThroughEye& planes,
    unsigned k,
    float length,
    const std::optional<raster::PlaneTest>& test
) {
    const PlaneThroughEye& plane = planes.planes[k];
    const glm::vec3 foot = point_of(plane, 0.5F, 0.6F);
    const glm::vec3 end = foot + plane.normal * length;
    const ImU32 color = sheet.theme[edge_tones[k]];
    sheet.line(foot, end, color, 2.0F);
    const auto tip = sheet.at(end);
    const auto from = sheet.at(foot);
    if (!tip || !from) {
        return;
    }
    sheet.list.AddCircleFilled(*from, sheet.theme.pixels(2.5F), color, 12);
    ImFont* font = sheet.theme.fonts.small_mono;
    const float size = sheet.theme.units(2);
    std::string label = edge_names[k];
    ImVec2 at{tip->x + size, tip->y - font->FontSize * 0.5F};
    if (test) {
        const bool inside = test->edges[k] >= 0.0;
        draw_mark(sheet.list, *tip, size, inside, sheet.theme);
        label += inside ? " +" : " −";
    } else {
        sheet.list.AddCircleFilled(*tip, sheet.theme.pixels(3.5F), color, 12);
    }
    const ImVec2 box = text_size(font, label);
    const float pad = sheet.theme.pixels(2);
    sheet.list.AddRectFilled(
        {at.x - pad, at.y},
        {at.x + box.x + pad, at.y + box.y},
        sheet.theme.faded(Tone::window, 0.8F),
        pad
    );
    draw_text(sheet.list, font, at, color, label);
}

} // namespace

void draw_planes_through_eye(
    const Context& context, const OrbitCamera& camera, const SpaceMap& map
) {
    const trace::Player& player = context.document.player();
    const trace::StepDetail& detail = player.detail();
    const auto planes = explain::planes_through_eye(player.recording(), detail, player.current());
    if (!planes) {
        return;
    }
    const Sheet sheet{*ImGui::GetWindowDrawList(), context.theme, camera, map};
    for (unsigned k = 0; k < 3; ++k) {
        draw_plane(sheet, planes->planes[k], edge_tones[k]);
    }

    float farthest = 0.0F;
    for (const PlaneThroughEye& plane : planes->planes) {
        farthest = std::max(farthest, glm::length(plane.edge[0]));
    }
    std::optional<raster::PlaneTest> test;
    if (planes->ray && detail.traversal && detail.traversal->planes) {
        test = detail.traversal->planes;
        const ImU32 color = sheet.theme[test->inside ? Tone::pass : Tone::fail];
        sheet.line(glm::vec3{0.0F}, *planes->ray * (farthest * rays.back()), color, 2.5F);
    }
    constexpr float part = 0.25F; // of the distance: as long as the planes are wide, about
    for (unsigned k = 0; k < 3; ++k) {
        draw_normal(sheet, *planes, k, farthest * part, test);
    }
}

} // namespace hs::viewer
