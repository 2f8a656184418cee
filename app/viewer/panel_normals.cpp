// Normals: one vertex's normal moved by the matrix itself and by its inverse transpose, against a
// tangent of the surface.
#include "app/viewer/formula_view.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/normal_story.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hs::viewer {
namespace {

using explain::NormalStory;
using explain::number;

struct Subject {
    std::uint32_t object = 0;
    std::uint32_t vertex = 0;
};

Subject subject_of(Context& context) {
    const trace::VertexDetail* vertex = context.document.vertex_detail(context.state.corner);
    return vertex == nullptr ? Subject{} : Subject{vertex->object, vertex->vertex};
}

std::string text(const glm::vec3& v) {
    return explain::point(v.x, v.y, v.z);
}

float degrees_between(float cosine) {
    constexpr float degrees = 57.2957795F;
    return std::acos(std::clamp(cosine, -1.0F, 1.0F)) * degrees;
}

void arrow(
    const Theme& theme, ImVec2 from, ImVec2 direction, float length, ImU32 color, const char* name
) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 tip{from.x + direction.x * length, from.y - direction.y * length};
    const float head = theme.units(2);
    const ImVec2 back{tip.x - direction.x * head, tip.y + direction.y * head};
    const ImVec2 across{direction.y * head * 0.5F, direction.x * head * 0.5F};
    list.AddLine(from, back, color, theme.pixels(2));
    list.AddTriangleFilled(
        tip, {back.x + across.x, back.y + across.y}, {back.x - across.x, back.y - across.y}, color
    );
    ImFont* font = theme.fonts.small_mono;
    draw_text(list, font, {tip.x + theme.pixels(4), tip.y - font->FontSize * 0.5F}, color, name);
}

/// The surface from its side: its tangent lies flat, the wrong normal leans as far as it does.
void draw_plane(const Theme& theme, const Rect& rect, const NormalStory& story, bool moved) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 foot{rect.x + rect.width * 0.5F, rect.bottom() - theme.units(6)};
    const float length =
        std::min(rect.width * 0.5F - theme.units(10), rect.height - theme.units(12));
    const float half = rect.width * 0.5F - theme.units(2);
    list.AddLine(
        {foot.x - half, foot.y}, {foot.x + half, foot.y}, theme[Tone::hairline], theme.pixels(3)
    );
    arrow(theme, foot, {1.0F, 0.0F}, length, theme[Tone::axis_x], moved ? "M·t" : "t");
    if (!moved) {
        arrow(theme, foot, {0.0F, 1.0F}, length, theme[Tone::accent], "n");
    } else {
        const float along = story.dot_by_matrix;
        const float up = glm::dot(story.by_matrix, story.by_inverse_transpose);
        arrow(theme, foot, {along, up}, length, theme[Tone::fail], "M·n");
        arrow(theme, foot, {0.0F, 1.0F}, length, theme[Tone::pass], "N·n");
    }
    const char* const name = moved ? "eye space" : "object space";
    draw_text(
        list,
        theme.fonts.small,
        {rect.x + theme.units(1), rect.bottom() - theme.units(5)},
        theme[Tone::quiet],
        name
    );
}

void draw_picture(const Theme& theme, const NormalStory& story) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float half = width * 0.5F;
    const float height = std::min(theme.units(36), half * 0.5F + theme.units(4));
    ImGui::Dummy({width, height});
    draw_plane(theme, {at.x, at.y, half, height}, story, false);
    draw_plane(theme, {at.x + half, at.y, half, height}, story, true);
}

void draw_products(const Theme& theme, const NormalStory& story) {
    small_mono(
        theme,
        fmt::format(
            "n = {}\nt = {}\nn·t = {}",
            text(story.normal),
            text(story.tangent),
            number(story.dot_before)
        )
    );
    small_mono(theme, fmt::format("M·t = {}", text(story.moved_tangent)), Tone::quiet);
    words(theme, "By the matrix itself", Tone::fail);
    small_mono(
        theme,
        fmt::format(
            "M·n = {}\n(M·n)·(M·t) = {}, {:.1f}°",
            text(story.by_matrix),
            number(story.dot_by_matrix),
            degrees_between(story.dot_by_matrix)
        )
    );
    words(theme, "By its inverse transpose", Tone::pass);
    small_mono(
        theme,
        fmt::format(
            "N·n = {}\n(N·n)·(M·t) = {}, {:.1f}°",
            text(story.by_inverse_transpose),
            number(story.dot_by_inverse_transpose),
            degrees_between(story.dot_by_inverse_transpose)
        )
    );
}

} // namespace

void draw_normals(Context& context) {
    const Theme& theme = context.theme;
    const trace::Recording& recording = context.document.recording();
    if (recording.objects.empty() || recording.objects.front().vertex_count == 0) {
        empty_note(theme, "The scene has no vertices, so there is no normal to move.");
        return;
    }
    const Subject subject = subject_of(context);
    heading(
        theme, fmt::format("The normal at vertex {} of object {}", subject.vertex, subject.object)
    );
    const auto story = explain::normal_story(recording, subject.object, subject.vertex);
    if (!story) {
        empty_note(
            theme,
            "This vertex has no normal, no edge beside it, or the object is squashed flat: nothing "
            "can be compared here. Step to another vertex."
        );
        return;
    }
    caption(
        theme,
        fmt::format(
            "The tangent t is the edge to vertex {}, without its part along n. All have length 1.",
            story->edge_end
        )
    );
    draw_picture(theme, *story);
    draw_products(theme, *story);
    caption(
        theme,
        "A tangent joins two points of the surface, so it moves as they do: by M. What stays "
        "perpendicular to it moves by N, the inverse transpose of M: in (N·n)·(M·t) the inverse "
        "undoes M, and n·t = 0 is left."
    );
    if (!story->executed) {
        caption(theme, "This frame does not do so: a fault was seeded.", Tone::fail);
    }
    draw_matrix(theme, "M: object to eye, directions", glm::mat4{story->matrix});
    draw_matrix(theme, "N: its inverse transpose", glm::mat4{story->inverse_transpose});
}

} // namespace hs::viewer
