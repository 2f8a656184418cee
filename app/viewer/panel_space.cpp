// The space view: the same vertices in object, world, eye, clip and normalized device coordinates,
// seen by a second camera from outside.
#include "app/viewer/panels.hpp"
#include "app/viewer/space_lines.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace hs::viewer {
namespace {

/// Beyond this many lines smoothing their edges costs more than it shows.
constexpr std::size_t most_smooth_lines = 2000;

void draw_toolbar(Context& context) {
    std::vector<Segment> list;
    for (const Named<Space>& row : names<Space>()) {
        list.push_back({row.name, row.explanation, ""});
    }
    const int chosen = static_cast<int>(context.state.space.space);
    const int clicked = segments(context.theme, "spaces", list, chosen);
    if (clicked >= 0) {
        context.state.space.space = static_cast<Space>(clicked);
    }
}

void take_mouse(SpaceView& view) {
    constexpr float radians_per_pixel = 0.008F;
    constexpr float steepest = 1.55F;
    ImGui::SetCursorScreenPos({view.area.x, view.area.y});
    ImGui::InvisibleButton("orbit", {view.area.width, view.area.height});
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActive()) {
        view.yaw += io.MouseDelta.x * radians_per_pixel;
        view.pitch =
            std::clamp(view.pitch + io.MouseDelta.y * radians_per_pixel, -steepest, steepest);
    }
    if (ImGui::IsItemHovered() && io.MouseWheel != 0.0F) {
        const float factor = io.MouseWheel > 0.0F ? 0.85F : 1.0F / 0.85F;
        view.distance = std::clamp(view.distance * factor, 0.15F, 8.0F);
    }
}

void draw_edges(const SpaceLines& lines, const Theme& theme) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool smooth = lines.edges().size() <= most_smooth_lines;
    const ImDrawListFlags flags = list.Flags;
    if (!smooth) {
        list.Flags &= ~ImDrawListFlags_AntiAliasedLines;
    }
    const ImU32 color = theme.faded(Tone::quiet, smooth ? 0.8F : 0.45F);
    for (const SpaceLines::Segment& segment : lines.edges()) {
        list.AddLine(segment[0], segment[1], color);
    }
    list.Flags = flags;
}

void draw_line(
    const SpaceLines& lines, const glm::vec3& a, const glm::vec3& b, ImU32 color, float width
) {
    if (const auto seen = lines.camera().project(a, b)) {
        ImGui::GetWindowDrawList()->AddLine((*seen)[0], (*seen)[1], color, width);
    }
}

void draw_axes(const SpaceLines& lines, const Theme& theme, Space space) {
    struct Axis {
        glm::vec3 direction;
        Tone tone;
        const char* name;
    };
    const float length = lines.radius() * 0.4F;
    const bool clip = space == Space::clip;
    const std::array<Axis, 3> axes{{
        {{length, 0.0F, 0.0F}, Tone::axis_x, "x"},
        {{0.0F, length, 0.0F}, Tone::axis_y, "y"},
        {{0.0F, 0.0F, clip ? -length : length}, Tone::axis_z, clip ? "w" : "z"},
    }};
    for (const Axis& axis : axes) {
        draw_line(lines, glm::vec3{0.0F}, axis.direction, theme[axis.tone], theme.pixels(2));
        if (const auto end = lines.camera().project(axis.direction * 1.08F)) {
            const ImVec2 size = text_size(theme.fonts.small_mono, axis.name);
            draw_text(
                *ImGui::GetWindowDrawList(),
                theme.fonts.small_mono,
                {end->x - size.x * 0.5F, end->y - size.y * 0.5F},
                theme[axis.tone],
                axis.name
            );
        }
    }
}

void draw_volume(const Context& context, const SpaceLines& lines) {
    const Space space = context.state.space.space;
    const std::uint32_t object = context.document.player().current().object;
    const auto corners = view_volume(context.document.recording(), space, object);
    if (!corners) {
        return;
    }
    const ImU32 color = context.theme.stage(trace::Stage::clip);
    for (unsigned i = 0; i < 4; ++i) {
        const unsigned next = (i + 1) % 4;
        const float width = context.theme.pixels(1.25F);
        draw_line(lines, (*corners)[i], (*corners)[next], color, width);
        draw_line(lines, (*corners)[i + 4], (*corners)[next + 4], color, width);
        draw_line(lines, (*corners)[i], (*corners)[i + 4], color, width);
    }
}

/// The eye is a point in world and eye space, and the apex of the pyramid in clip space.
void draw_eye(const Context& context, const SpaceLines& lines) {
    const Space space = context.state.space.space;
    const scene::Camera& camera = context.document.scene().camera;
    if (space == Space::object || space == Space::ndc ||
        camera.projection.kind == scene::ProjectionKind::identity) {
        return;
    }
    const glm::vec3 place = space == Space::world ? camera.eye : glm::vec3{0.0F};
    if (const auto eye = lines.camera().project(place)) {
        const Theme& theme = context.theme;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddCircleFilled(*eye, theme.pixels(4), theme.stage(trace::Stage::clip), 16);
        draw_text(
            list,
            theme.fonts.small,
            {eye->x + theme.units(2), eye->y - theme.units(2)},
            theme[Tone::text],
            "eye"
        );
    }
}

void draw_current(const Context& context, const SpaceLines& lines) {
    const trace::TriangleDetail* triangle = context.document.triangle_detail();
    const trace::Step& step = context.document.player().current();
    const trace::Recording& recording = context.document.recording();
    const Space space = context.state.space.space;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    constexpr std::array tones{Tone::vertex_0, Tone::vertex_1, Tone::vertex_2};
    if (step.in_vertex_stage()) {
        const auto place = vertex_in_space(recording, space, step.object, step.vertex);
        const auto point = place ? lines.camera().project(*place) : std::nullopt;
        if (point) {
            list.AddCircleFilled(*point, context.theme.pixels(4), context.theme[Tone::accent], 16);
        }
    }
    if (triangle == nullptr) {
        return;
    }
    std::array<std::optional<glm::vec3>, 3> corners;
    for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t vertex = triangle->vertices[static_cast<int>(k)];
        corners[k] = vertex_in_space(recording, space, triangle->object, vertex);
    }
    for (unsigned k = 0; k < 3; ++k) {
        const auto& a = corners[k];
        const auto& b = corners[(k + 1) % 3];
        if (a && b) {
            draw_line(lines, *a, *b, context.theme[Tone::accent], context.theme.pixels(2));
        }
    }
    for (unsigned k = 0; k < 3; ++k) {
        const auto point = corners[k] ? lines.camera().project(*corners[k]) : std::nullopt;
        if (!point) {
            continue;
        }
        const ImU32 color = context.theme[tones[k]];
        list.AddCircleFilled(*point, context.theme.pixels(4), color, 16);
        draw_text(
            list,
            context.theme.fonts.small_mono,
            {point->x + context.theme.units(1), point->y + context.theme.pixels(2)},
            color,
            fmt::format("v{}", k)
        );
    }
}

/// Below the drawing: what the lines are, and what is left out.
void draw_notes(const Context& context, const SpaceLines& lines, const Rect& rect) {
    const Theme& theme = context.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::size_t stride_edges = lines.all_edges();
    std::string text{named(context.state.space.space).explanation};
    if (lines.edges().size() * 2 < stride_edges) {
        text = fmt::format("{} of {} edges shown; ", lines.edges().size(), stride_edges) + text;
    }
    draw_text(
        list,
        theme.fonts.small,
        {rect.x, rect.y},
        theme[Tone::quiet],
        shorten(theme.fonts.small, text, rect.width)
    );
    draw_text(
        list,
        theme.fonts.small,
        {rect.x, rect.y + theme.units(5)},
        theme[Tone::quiet],
        shorten(theme.fonts.small, "drag turns · wheel zooms", rect.width)
    );
}

} // namespace

void draw_space(Context& context, const Rect& rect, SpaceLines& lines) {
    const Theme& theme = context.theme;
    begin_panel("space", rect, theme, false);
    if (!context.document.is_open()) {
        heading(theme, "Space");
        empty_note(
            theme, "Here you will see the meshes in every coordinate space, with the view volume."
        );
        end_panel();
        return;
    }
    draw_toolbar(context);
    SpaceView& view = context.state.space;
    const float pad = theme.units(3);
    const float footer = theme.units(12);
    const float top = ImGui::GetCursorScreenPos().y;
    view.area = {
        rect.x + pad, top, rect.width - 2.0F * pad, std::max(8.0F, rect.bottom() - footer - top)};
    take_mouse(view);
    lines.update(context.document, view);

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 corner{view.area.right(), view.area.bottom()};
    list.AddRectFilled({view.area.x, view.area.y}, corner, theme[Tone::window]);
    ImGui::PushClipRect({view.area.x, view.area.y}, corner, true);
    draw_edges(lines, theme);
    draw_volume(context, lines);
    draw_axes(lines, theme, view.space);
    draw_eye(context, lines);
    draw_current(context, lines);
    ImGui::PopClipRect();
    draw_notes(
        context, lines, {view.area.x, view.area.bottom() + theme.units(2), view.area.width, 0.0F}
    );
    end_panel();
}

} // namespace hs::viewer
