#include "app/viewer/space_drawing.hpp"

#include "app/viewer/space_planes.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hs::viewer {
namespace {

/// Beyond this many lines smoothing their edges costs more than it shows.
constexpr std::size_t most_smooth_lines = 2000;
constexpr int most_sections = 40;

/// The drawing under way.
struct Scene {
    const Context& context;
    const SpaceLines& lines;
    SpaceMap map; ///< of the current object
    ImDrawList& list;

    [[nodiscard]] const Theme& theme() const { return context.theme; }
    [[nodiscard]] const SpaceView& view() const { return context.state.space; }

    void line(const glm::vec3& a, const glm::vec3& b, ImU32 color, float width) const {
        if (const auto seen = lines.camera().project(a, b)) {
            list.AddLine((*seen)[0], (*seen)[1], color, theme().pixels(width));
        }
    }
    /// Between two points of eye space: straight in every space.
    void eye_line(const glm::vec3& a, const glm::vec3& b, ImU32 color, float width) const {
        const auto from = map.of_eye(a);
        const auto to = map.of_eye(b);
        if (from && to) {
            line(*from, *to, color, width);
        }
    }
    void eye_loop(const std::array<glm::vec3, 4>& corners, ImU32 color, float width) const {
        for (unsigned i = 0; i < 4; ++i) {
            eye_line(corners[i], corners[(i + 1) % 4], color, width);
        }
    }
    /// A filled polygon of eye space; not drawn unless all of it is in sight.
    void eye_fill(const std::array<glm::vec3, 4>& corners, ImU32 color) const {
        std::array<ImVec2, 4> points;
        for (unsigned i = 0; i < 4; ++i) {
            const auto place = map.of_eye(corners[i]);
            const auto point = place ? lines.camera().project(*place) : std::nullopt;
            if (!point) {
                return;
            }
            points[i] = *point;
        }
        list.AddQuadFilled(points[0], points[1], points[2], points[3], color);
    }
    void label(ImVec2 at, ImU32 color, std::string_view text) const {
        draw_text(list, theme().fonts.small_mono, at, color, text);
    }
};

void draw_edges(const Scene& scene) {
    const std::vector<SpaceLines::Segment>& edges = scene.lines.edges();
    const bool smooth = edges.size() <= most_smooth_lines;
    const ImDrawListFlags flags = scene.list.Flags;
    if (!smooth) {
        scene.list.Flags &= ~ImDrawListFlags_AntiAliasedLines;
    }
    const ImU32 color = scene.theme().faded(Tone::quiet, smooth ? 0.8F : 0.45F);
    for (const SpaceLines::Segment& segment : edges) {
        scene.list.AddLine(segment[0], segment[1], color);
    }
    scene.list.Flags = flags;
}

/// Sections at equal distances from the eye; seen from the side they are labeled. Under the
/// projection they crowd toward the far plane: that is where depth loses its precision.
void draw_sections(const Scene& scene, const ViewVolume& volume) {
    const ImU32 hue = scene.theme().stage(trace::Stage::clip);
    const ImU32 faint = (hue & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 110);
    float last_end = -1.0e9F;
    for (const float distance : section_distances(volume, scene.lines.interest(), most_sections)) {
        const std::array<glm::vec3, 4> corners = volume.section(distance);
        scene.eye_loop(corners, faint, 1.0F);
        const auto foot = scene.view().side ? scene.map.of_eye(corners[0]) : std::nullopt;
        const auto at = foot ? scene.lines.camera().project(*foot) : std::nullopt;
        if (!at) {
            continue;
        }
        const std::string text = fmt::format("{:g}", distance);
        const float width = text_size(scene.theme().fonts.small_mono, text).x;
        const float x = at->x - width * 0.5F;
        if (x > last_end + scene.theme().units(1)) {
            scene.label({x, at->y + scene.theme().pixels(3)}, scene.theme()[Tone::quiet], text);
            last_end = x + width;
        }
    }
}

void draw_volume(const Scene& scene, const ViewVolume& volume) {
    const ImU32 hue = scene.theme().stage(trace::Stage::clip);
    const ImU32 tint = (hue & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 36);
    draw_sections(scene, volume);
    scene.eye_fill(volume.near, tint); // the image plane, as it were
    scene.eye_loop(volume.near, hue, 1.5F);
    scene.eye_loop(volume.far, hue, 1.25F);
    for (unsigned i = 0; i < 4; ++i) {
        scene.eye_line(volume.near[i], volume.far[i], hue, 1.25F);
    }
}

/// The eye with its lines of sight to the image's corners. On the way to NDC it withdraws, and the
/// lines of sight become parallel.
void draw_eye(const Scene& scene, const ViewVolume& volume) {
    const auto place = volume.has_eye ? scene.map.of_eye(glm::vec3{0.0F}) : std::nullopt;
    if (!place) {
        return;
    }
    const ImU32 hue = scene.theme().stage(trace::Stage::clip);
    const ImU32 faint = (hue & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 110);
    for (const glm::vec3& corner : volume.near) {
        scene.eye_line(glm::vec3{0.0F}, corner, faint, 1.0F);
    }
    if (const auto eye = scene.lines.camera().project(*place)) {
        const Theme& theme = scene.theme();
        scene.list.AddCircleFilled(*eye, theme.pixels(4), hue, 16);
        draw_text(
            scene.list,
            theme.fonts.small,
            {eye->x + theme.units(2), eye->y - theme.units(4)},
            theme[Tone::text],
            "eye"
        );
    }
}

/// The third axis: z of eye and NDC, w of clip space; drawn so that what is farther lies farther.
struct DepthAxis {
    const char* name;
    float direction;
};

DepthAxis depth_axis(const Scene& scene) {
    const trace::Recording& recording = scene.context.document.recording();
    const bool reversed = recording.settings().depth_convention == scene::DepthConvention::reversed;
    switch (scene.view().space) {
    case Space::object:
    case Space::world: return {"z", 1.0F};
    case Space::eye: return {"z", -scene::forward_sign(recording.scene().camera)};
    case Space::clip: return {"w", -1.0F};
    case Space::ndc: return {"z", reversed ? 1.0F : -1.0F};
    }
    HS_CHECK(false, "every space has axes");
    return {};
}

void draw_axes(const Scene& scene) {
    struct Axis {
        glm::vec3 direction;
        Tone tone;
        const char* name;
    };
    const float length = scene.lines.radius() * 0.4F;
    const DepthAxis depth = depth_axis(scene);
    const std::array<Axis, 3> axes{{
        {{length, 0.0F, 0.0F}, Tone::axis_x, "x"},
        {{0.0F, length, 0.0F}, Tone::axis_y, "y"},
        {{0.0F, 0.0F, depth.direction * length}, Tone::axis_z, depth.name},
    }};
    for (std::size_t i = scene.view().side ? 1 : 0; i < axes.size(); ++i) {
        const Axis& axis = axes[i];
        const ImU32 color = scene.theme()[axis.tone];
        scene.line(glm::vec3{0.0F}, axis.direction, color, 2.0F);
        if (const auto end = scene.lines.camera().project(axis.direction * 1.08F)) {
            const ImVec2 size = text_size(scene.theme().fonts.small_mono, axis.name);
            scene.label({end->x - size.x * 0.5F, end->y - size.y * 0.5F}, color, axis.name);
        }
    }
}

void draw_current_vertex(const Scene& scene, const trace::Step& step) {
    const auto place = scene.map.of_vertex(step.vertex);
    if (const auto point = place ? scene.lines.camera().project(*place) : std::nullopt) {
        scene.list.AddCircleFilled(
            *point, scene.theme().pixels(4), scene.theme()[Tone::accent], 16
        );
    }
}

void draw_current_triangle(const Scene& scene, const trace::TriangleDetail& triangle) {
    constexpr std::array tones{Tone::vertex_0, Tone::vertex_1, Tone::vertex_2};
    std::array<std::optional<glm::vec3>, 3> corners;
    for (unsigned k = 0; k < 3; ++k) {
        corners[k] = scene.map.of_vertex(triangle.vertices[static_cast<int>(k)]);
    }
    for (unsigned k = 0; k < 3; ++k) {
        const auto& a = corners[k];
        const auto& b = corners[(k + 1) % 3];
        if (a && b) {
            scene.line(*a, *b, scene.theme()[Tone::accent], 2.0F);
        }
    }
    for (unsigned k = 0; k < 3; ++k) {
        const auto point = corners[k] ? scene.lines.camera().project(*corners[k]) : std::nullopt;
        if (point) {
            const Theme& theme = scene.theme();
            const ImU32 color = theme[tones[k]];
            scene.list.AddCircleFilled(*point, theme.pixels(4), color, 16);
            const ImVec2 beside{point->x + theme.units(1), point->y + theme.pixels(2)};
            scene.label(beside, color, fmt::format("v{}", k));
        }
    }
}

/// The current ray from the near to the far plane with its hits so far; the nearest is labeled.
void draw_current_ray(const Scene& scene, const trace::SweepDetail& detail) {
    const Theme& theme = scene.theme();
    const visibility::RayCast& cast = *detail.ray;
    const glm::mat4& view =
        scene.context.document.recording().frame->calls().front().vertex.transforms.view.matrix;
    const auto in_eye = [&](double t) {
        const glm::vec3 world{cast.ray.origin + t * cast.ray.direction};
        return glm::vec3{view * glm::vec4{world, 1.0F}};
    };
    scene.eye_line(in_eye(0.0), in_eye(1.0), theme.faded(Tone::halo, 0.8F), 3.0F);
    scene.eye_line(in_eye(0.0), in_eye(1.0), theme[Tone::selected], 1.5F);
    for (const visibility::SweepEvent& event : detail.decisions) {
        const bool hit = event.kind == visibility::SweepEventKind::meet && event.verdict;
        const auto place = hit ? scene.map.of_eye(in_eye(event.value)) : std::nullopt;
        const auto point = place ? scene.lines.camera().project(*place) : std::nullopt;
        if (!point) {
            continue;
        }
        const bool nearest = event.polygon == cast.nearest;
        const ImU32 color = theme[nearest ? Tone::accent : Tone::quiet];
        scene.list.AddCircleFilled(*point, theme.pixels(nearest ? 5.0F : 3.5F), color, 16);
        if (nearest) {
            const ImVec2 beside{point->x + theme.units(2), point->y - theme.units(2)};
            scene.label(beside, color, fmt::format("t = {:.4f}", event.value));
        }
    }
}

} // namespace

std::vector<float> section_distances(const ViewVolume& volume, float interest, int most) {
    constexpr float wanted = 4.0F; // steps up to what is of interest
    const float length = interest - volume.near_distance;
    std::vector<float> distances;
    if (!(length > 0.0F)) {
        return distances;
    }
    const float power = std::pow(10.0F, std::floor(std::log10(length / wanted)));
    const float digit = length / wanted / power;
    const float step = power * (digit < 2.0F ? 1.0F : digit < 5.0F ? 2.0F : 5.0F);
    const float first = std::floor(volume.near_distance / step) + 1.0F;
    for (int i = 0; i < most; ++i) {
        const float distance = (first + static_cast<float>(i)) * step;
        if (distance >= volume.far_distance) {
            break;
        }
        distances.push_back(distance);
    }
    return distances;
}

void draw_spaces_content(Context& context, const SpaceLines& lines) {
    const trace::Recording& recording = context.document.recording();
    const trace::Step& step = context.document.player().current();
    if (recording.frame->calls().empty()) {
        return;
    }
    const Scene scene{
        context,
        lines,
        SpaceMap{recording, context.state.space, step.object},
        *ImGui::GetWindowDrawList()};
    draw_edges(scene);
    if (const std::optional<ViewVolume>& volume = lines.volume()) {
        draw_volume(scene, *volume);
        draw_eye(scene, *volume);
    }
    draw_axes(scene);
    if (step.in_vertex_stage()) {
        draw_current_vertex(scene, step);
    }
    draw_planes_through_eye(context, lines.camera(), scene.map);
    if (const trace::TriangleDetail* triangle = context.document.triangle_detail()) {
        draw_current_triangle(scene, *triangle);
    }
    if (const trace::SweepDetail* sweep = context.document.sweep_detail(); sweep && sweep->ray) {
        draw_current_ray(scene, *sweep);
    }
}

} // namespace hs::viewer
