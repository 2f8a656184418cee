// The projection: what its matrix does to one point, from "drop z" to the matrix that is executed;
// what each convention makes of depth; and the same way by hand.
#include "app/viewer/formula_view.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"
#include "core/explain/projection_ladder.hpp"

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>

namespace hs::viewer {
namespace {

using explain::number;
using explain::ProjectionRung;

/// What the panel is about: a point in eye space and the camera that projects it.
struct Subject {
    const scene::Camera& camera;
    scene::DepthConvention convention;
    PixelRect viewport;
    glm::vec3 eye;
    std::string name;

    [[nodiscard]] float aspect() const {
        return static_cast<float>(viewport.width()) / static_cast<float>(viewport.height());
    }
    [[nodiscard]] float distance() const { return scene::forward_sign(camera) * eye.z; }
};

Subject subject_of(Context& context) {
    const trace::Recording& recording = context.document.recording();
    const trace::VertexDetail* vertex = context.document.vertex_detail(context.state.corner);
    const bool first = vertex == nullptr;
    const trace::VertexDetail detail = first ? trace::vertex_detail(recording, 0, 0) : *vertex;
    const math::EyePosition& eye = detail.work.eye;
    return {
        context.document.scene().camera,
        recording.settings().depth_convention,
        recording.settings().viewport(),
        {eye.x, eye.y, eye.z},
        fmt::format(
            "vertex {} of object {}{}",
            detail.vertex,
            detail.object,
            first ? " (step to another, or into a triangle)" : ""
        )};
}

/// Three digits are enough to see what an entry does; the inspector has them all.
std::string entry_text(float value) {
    return value == 0.0F ? "0" : fmt::format("{:.3g}", value);
}

constexpr int entry_width = 7; // characters

void draw_entries(const Theme& theme, const glm::mat4& m) {
    std::string text;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            text += fmt::format("{:>{}}", entry_text(m[column][row]), entry_width);
        }
        text += row < 3 ? "\n" : "";
    }
    small_mono(theme, text);
}

std::string point_text(const glm::vec3& p) {
    return fmt::format("({}, {}, {})", entry_text(p.x), entry_text(p.y), entry_text(p.z));
}

void draw_rung(const Theme& theme, int number_of_rung, const ProjectionRung& rung) {
    words(theme, fmt::format("{}. {}", number_of_rung, rung.title), Tone::accent);
    caption(theme, rung.idea);
    draw_entries(theme, rung.matrix);
    small_mono(theme, fmt::format("M·p = {}", point_text(glm::vec3{rung.clip})), Tone::quiet);
    small_mono(
        theme,
        rung.divided
            ? fmt::format("÷ w {} = {}", entry_text(rung.clip.w), point_text(*rung.divided))
            : std::string{"w = 0: no divide"},
        rung.divided ? Tone::text : Tone::fail
    );
    caption(theme, fmt::format("Depth: {}.", rung.survives), Tone::text);
}

/// Side by side where there is room, else below each other.
void draw_ladder(const Theme& theme, const Subject& subject) {
    const std::vector<ProjectionRung> ladder = explain::projection_ladder(
        subject.camera, subject.aspect(), subject.convention, subject.eye
    );
    const float entry = text_size(theme.fonts.small_mono, "0").x * entry_width;
    const float needed = (entry * 4.0F + theme.units(5)) * static_cast<float>(ladder.size());
    const bool beside = ImGui::GetContentRegionAvail().x >= needed;
    const int columns = beside ? static_cast<int>(ladder.size()) : 1;
    if (!ImGui::BeginTable("ladder", columns, ImGuiTableFlags_SizingStretchSame)) {
        return;
    }
    for (std::size_t i = 0; i < ladder.size(); ++i) {
        ImGui::TableNextColumn();
        draw_rung(theme, static_cast<int>(i) + 1, ladder[i]);
        ImGui::Dummy({0.0F, theme.units(2)});
    }
    ImGui::EndTable();
}

void draw_conventions(const Theme& theme, const Subject& subject) {
    const auto list = explain::depth_in_conventions(subject.camera, subject.aspect(), subject.eye);
    if (!list) {
        caption(theme, "w = 0: this point has no depth.", Tone::fail);
        return;
    }
    constexpr std::array rows{"A", "B", "z_clip", "z_ndc", "depth"};
    if (!ImGui::BeginTable("conventions", 4, ImGuiTableFlags_SizingStretchSame)) {
        return;
    }
    ImGui::TableNextColumn();
    for (const explain::ConventionDepth& one : *list) {
        ImGui::TableNextColumn();
        const bool executed = one.convention == subject.convention;
        caption(theme, name_of(one.convention), executed ? Tone::accent : Tone::quiet);
    }
    for (std::size_t row = 0; row < rows.size(); ++row) {
        ImGui::TableNextColumn();
        caption(theme, rows[row]);
        for (const explain::ConventionDepth& one : *list) {
            const std::array values{one.a, one.b, one.z_clip, one.z_ndc, one.depth};
            ImGui::TableNextColumn();
            small_mono(theme, number(values[row]));
        }
    }
    ImGui::EndTable();
    caption(
        theme,
        "z_clip = A·z + B. A z-buffer stores this depth, not the distance; what differs is only "
        "which end of the range is near. The frame runs the marked one."
    );
}

void draw_matrix_entries(const Theme& theme, const Subject& subject) {
    const auto list = explain::matrix_entries(subject.camera, subject.aspect(), subject.convention);
    for (const explain::MatrixEntry& e : list) {
        small_mono(
            theme,
            fmt::format(
                "row {} column {}:  {}{} = {}",
                e.row + 1,
                e.column + 1,
                e.symbolic,
                e.with_numbers.empty() ? "" : " = " + e.with_numbers,
                number(e.value)
            )
        );
        caption(theme, e.meaning);
    }
    const explain::FrustumLimits v =
        explain::frustum_limits(subject.camera.projection, subject.aspect());
    small_mono(
        theme,
        fmt::format(
            "on the near plane  l = {}  r = {}  b = {}  t = {}",
            number(v.left),
            number(v.right),
            number(v.bottom),
            number(v.top)
        )
    );
    if (subject.camera.projection.kind == scene::ProjectionKind::perspective) {
        caption(theme, "t = n·tan(fov/2), r = t·aspect; l = −r and b = −t: the axis is central");
    } else if (subject.camera.projection.kind == scene::ProjectionKind::frustum) {
        caption(theme, "given as they are: the line of sight need not meet the image's middle");
    }
}

/// Eye, image plane and point from the side: two similar triangles.
void draw_similar_triangles(const Theme& theme, const Subject& subject) {
    const float near = subject.camera.projection.near;
    const float distance = subject.distance();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = theme.units(30);
    ImGui::Dummy({width, height});
    const float pad = theme.units(8);
    const float axis = at.y + height * (subject.eye.y >= 0.0F ? 0.8F : 0.2F);
    const float right = std::max(distance, near) * 1.05F;
    const float across = (width - 2.0F * pad) / right;
    const float up = height * 0.6F / std::max(1.0e-6F, std::abs(subject.eye.y));
    const auto place = [&](float d, float y) {
        return ImVec2{at.x + pad + d * across, axis - y * up};
    };
    const float on_plane = subject.eye.y * near / distance;
    list.AddLine(place(0.0F, 0.0F), place(right, 0.0F), theme[Tone::quiet], theme.pixels(1));
    list.AddLine(
        {place(near, 0.0F).x, at.y},
        {place(near, 0.0F).x, at.y + height},
        theme.stage(trace::Stage::clip),
        theme.pixels(1.5F)
    );
    const ImVec2 point = place(distance, subject.eye.y);
    list.AddLine(place(0.0F, 0.0F), point, theme[Tone::accent], theme.pixels(1.5F));
    list.AddLine(place(distance, 0.0F), point, theme[Tone::axis_y], theme.pixels(1.5F));
    list.AddLine(place(near, 0.0F), place(near, on_plane), theme[Tone::axis_y], theme.pixels(3));
    list.AddCircleFilled(place(0.0F, 0.0F), theme.pixels(3), theme[Tone::text], 12);
    list.AddCircleFilled(point, theme.pixels(3), theme[Tone::accent], 12);
    ImFont* font = theme.fonts.small_mono;
    const float down = subject.eye.y >= 0.0F ? theme.pixels(3) : -font->FontSize - theme.pixels(3);
    const auto label = [&](float d, const std::string& text) {
        const ImVec2 foot = place(d, 0.0F);
        const float x = std::clamp(
            foot.x - text_size(font, text).x * 0.5F,
            at.x,
            std::max(at.x, at.x + width - text_size(font, text).x)
        );
        draw_text(list, font, {x, foot.y + down}, theme[Tone::text], text);
    };
    label(0.0F, "eye");
    label(distance, fmt::format("d {}", entry_text(distance)));
    const std::string plane = fmt::format("n {}", entry_text(near));
    if (place(near, 0.0F).x - place(0.0F, 0.0F).x > text_size(font, plane).x + theme.units(4) &&
        place(distance, 0.0F).x - place(near, 0.0F).x > text_size(font, plane).x * 2.0F) {
        label(near, plane);
    }
}

struct PathLine {
    const char* place;
    std::string by_hand;
    std::string by_matrix;
};

std::vector<PathLine> path_lines(const Subject& subject, const explain::ByHand& hand) {
    const ProjectionRung matrix =
        explain::projection_ladder(
            subject.camera, subject.aspect(), subject.convention, subject.eye
        )
            .back();
    const explain::FrustumLimits v =
        explain::frustum_limits(subject.camera.projection, subject.aspect());
    const auto viewport = geometry::make_viewport(subject.viewport, subject.convention);
    const glm::vec4& clip = matrix.clip;
    const auto window = geometry::to_window({clip.x, clip.y, clip.z, clip.w}, viewport);
    const bool divides = clip.w != 1.0F;
    return {
        {"eye", point_text(subject.eye), fmt::format("{}, w = 1", point_text(subject.eye))},
        {divides ? "image plane" : "parallel",
         divides ? fmt::format(
                       "n·x/d = {}\nn·y/d = {}\nz kept aside",
                       number(hand.on_plane.x),
                       number(hand.on_plane.y)
                   )
                 : fmt::format("x = {}\ny = {}", number(hand.on_plane.x), number(hand.on_plane.y)),
         fmt::format(
             "M·p, x = {}\n     y = {}\n     w = {}", number(clip.x), number(clip.y), number(clip.w)
         )},
        {"NDC",
         fmt::format(
             "2·(x − {})/{} − 1\n= {}\nlikewise y\n= {}",
             entry_text(v.left),
             entry_text(v.right - v.left),
             number(hand.ndc.x),
             number(hand.ndc.y)
         ),
         fmt::format("x/w\n= {}\ny/w\n= {}", number(window.ndc.x), number(window.ndc.y))},
        {"raster",
         fmt::format(
             "(x + 1)/2·{} = {}\n(1 − y)/2·{} = {}",
             subject.viewport.width(),
             number(hand.raster.x + static_cast<float>(subject.viewport.x0)),
             subject.viewport.height(),
             number(hand.raster.y + static_cast<float>(subject.viewport.y0))
         ),
         fmt::format("{}\n{}", number(window.window.x), number(window.window.y))},
    };
}

void draw_by_hand(const Theme& theme, const Subject& subject) {
    const auto hand = explain::project_by_hand(
        subject.camera, subject.viewport.width(), subject.viewport.height(), subject.eye
    );
    if (!hand) {
        caption(
            theme,
            "This point lies at or behind the eye: no line of sight through the image plane meets "
            "it.",
            Tone::fail
        );
        return;
    }
    if (hand->distance != 0.0F && hand->on_plane != glm::vec2{subject.eye}) {
        draw_similar_triangles(theme, subject);
    }
    if (!ImGui::BeginTable("by hand", 3, ImGuiTableFlags_SizingStretchProp)) {
        return;
    }
    ImGui::TableSetupColumn("", 0, 0.7F);
    ImGui::TableSetupColumn("by hand", 0, 1.5F);
    ImGui::TableSetupColumn("by matrix", 0, 1.2F);
    ImGui::TableNextColumn();
    for (const char* const title : {"by hand", "by matrix"}) {
        ImGui::TableNextColumn();
        caption(theme, title);
    }
    for (const PathLine& line : path_lines(subject, *hand)) {
        ImGui::TableNextColumn();
        caption(theme, line.place);
        ImGui::TableNextColumn();
        small_mono(theme, line.by_hand);
        ImGui::TableNextColumn();
        small_mono(theme, line.by_matrix);
    }
    ImGui::EndTable();
}

void draw_row_vectors(const Theme& theme, const Subject& subject) {
    const glm::mat4 m =
        scene::projection_transform(subject.camera, subject.aspect(), subject.convention).matrix;
    caption(theme, "p' = M·p with columns (OpenGL, here); p'ᵀ = pᵀ·Mᵀ with rows (Direct3D):");
    draw_entries(theme, glm::transpose(m));
    const glm::vec4 p = glm::vec4{subject.eye, 1.0F} * glm::transpose(m);
    small_mono(
        theme,
        fmt::format("pᵀ·Mᵀ = {}, w = {}: the same", point_text(glm::vec3{p}), entry_text(p.w)),
        Tone::quiet
    );
}

} // namespace

void draw_projection(Context& context) {
    const Theme& theme = context.theme;
    if (context.document.recording().frame->calls().empty()) {
        empty_note(theme, "The scene has no objects, so there is no point to project.");
        return;
    }
    const Subject subject = subject_of(context);
    heading(theme, "One point through the projection");
    caption(
        theme,
        fmt::format(
            "{}: p = {} in eye space, {} in front of the eye",
            subject.name,
            explain::point(subject.eye.x, subject.eye.y, subject.eye.z),
            number(subject.distance())
        )
    );
    ImGui::Dummy({0.0F, theme.units(1)});
    draw_ladder(theme, subject);
    heading(theme, "What each convention makes of depth");
    draw_conventions(theme, subject);
    heading(theme, "By hand and by matrix");
    draw_by_hand(theme, subject);
    if (subject.camera.projection.kind != scene::ProjectionKind::identity) {
        heading(theme, "Every entry");
        draw_matrix_entries(theme, subject);
    }
    heading(theme, "Rows or columns");
    draw_row_vectors(theme, subject);
}

} // namespace hs::viewer
