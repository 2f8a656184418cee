// The inspector's tabs for a vertex and for a triangle.
#include "app/viewer/formula_view.hpp"
#include "app/viewer/lesson_hiding.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/formulas.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>

#include <array>

namespace hs::viewer {
namespace {

using trace::TriangleDetail;
using trace::VertexDetail;

/// The vertex the current step is about, or the chosen corner of its triangle.
const VertexDetail* current_vertex(Context& context) {
    const trace::Step& step = context.document.player().current();
    if (step.in_vertex_stage()) {
        const trace::StepDetail& detail = context.document.player().detail();
        return detail.vertex ? &*detail.vertex : nullptr;
    }
    const TriangleDetail* triangle = context.document.triangle_detail();
    return triangle == nullptr ? nullptr
                               : &triangle->corners[static_cast<std::size_t>(context.state.corner)];
}

void choose_corner(Context& context, const TriangleDetail& triangle) {
    const std::array labels{
        fmt::format("v0: {}", triangle.vertices.a),
        fmt::format("v1: {}", triangle.vertices.b),
        fmt::format("v2: {}", triangle.vertices.c)};
    const std::array list{
        Segment{labels[0], "first corner and its number in the mesh", ""},
        Segment{labels[1], "second corner", ""},
        Segment{labels[2], "third corner, the provoking vertex", ""}};
    const int clicked = segments(context.theme, "corners", list, context.state.corner);
    if (clicked >= 0) {
        context.state.corner = clicked;
    }
}

/// The same vertex in every space, one line each.
void draw_spaces(Context& context, const VertexDetail& vertex) {
    const Theme& theme = context.theme;
    struct Line {
        const char* name;
        std::string numbers;
    };
    const auto four = [](const glm::vec4& v) {
        return fmt::format(
            "{:>9} {:>9} {:>9} {:>8}",
            explain::number(v.x),
            explain::number(v.y),
            explain::number(v.z),
            explain::number(v.w)
        );
    };
    std::vector<Line> lines{
        {"object", four(math::to_vec4(vertex.work.object))},
        {"world", four(math::to_vec4(vertex.work.world))},
        {"eye", four(math::to_vec4(vertex.work.eye))},
        {"clip", four(math::to_vec4(vertex.work.clip))},
    };
    if (vertex.window.status != geometry::WindowStatus::at_eye) {
        const auto& ndc = vertex.window.ndc;
        const auto& window = vertex.window.window;
        const auto three = [](float x, float y, float z) {
            return fmt::format(
                "{:>9} {:>9} {:>9}", explain::number(x), explain::number(y), explain::number(z)
            );
        };
        lines.push_back({"ndc", three(ndc.x, ndc.y, ndc.z)});
        lines.push_back({"window", three(window.x, window.y, window.depth)});
    }
    const UseFont use{theme.fonts.small_mono};
    for (const Line& line : lines) {
        ImGui::PushStyleColor(ImGuiCol_Text, theme[Tone::quiet]);
        ImGui::TextUnformatted(line.name);
        ImGui::PopStyleColor();
        ImGui::SameLine(theme.units(13));
        const bool hidden = hides_space(context.viewer, line.name);
        ImGui::TextUnformatted(hidden ? "        ?" : line.numbers.c_str());
    }
    if (vertex.window.status == geometry::WindowStatus::at_eye) {
        caption(theme, "w = 0: no perspective divide, no place in the window.", Tone::fail);
    }
}

int lit_vertex_formula(const trace::Step& step) {
    return step.in_vertex_stage()
               ? static_cast<int>(step.kind) - static_cast<int>(trace::StepKind::vertex_world)
               : -1;
}

/// What this step computed comes first, so that it is in sight.
void draw_vertex_formulas(const Theme& theme, const std::vector<explain::Formula>& list, int lit) {
    if (lit >= 0 && lit < static_cast<int>(list.size())) {
        draw_formula(theme, list[static_cast<std::size_t>(lit)], true);
    }
    for (int i = 0; i < static_cast<int>(list.size()); ++i) {
        if (i != lit) {
            draw_formula(theme, list[static_cast<std::size_t>(i)], false);
        }
    }
}

/// One bit per plane and vertex: 1 is outside.
void draw_outcodes(const Theme& theme, const TriangleDetail& triangle, int planes) {
    const UseFont use{theme.fonts.small_mono};
    ImGui::Dummy({0.0F, 0.0F});
    ImGui::SameLine(theme.units(16));
    ImGui::PushStyleColor(ImGuiCol_Text, theme[Tone::quiet]);
    ImGui::TextUnformatted("  v0  v1  v2");
    ImGui::PopStyleColor();
    for (int k = 0; k < planes; ++k) {
        const auto plane = static_cast<geometry::ClipPlane>(k);
        std::string bits;
        for (const geometry::Outcode code : triangle.outcodes) {
            const bool outside =
                (static_cast<unsigned>(code) >> static_cast<unsigned>(k) & 1U) != 0;
            bits += outside ? "   1" : "   0";
        }
        ImGui::PushStyleColor(ImGuiCol_Text, theme[Tone::quiet]);
        ImGui::TextUnformatted(name_of(plane).data());
        ImGui::PopStyleColor();
        ImGui::SameLine(theme.units(16));
        const bool crossed = bits.find('1') != std::string::npos;
        ImGui::PushStyleColor(ImGuiCol_Text, theme[crossed ? Tone::fail : Tone::text]);
        ImGui::TextUnformatted(bits.c_str());
        ImGui::PopStyleColor();
    }
}

void draw_passes(const Theme& theme, const TriangleDetail& triangle) {
    for (const trace::ClipPass& pass : triangle.passes) {
        row(theme,
            fmt::format("plane {}", name_of(pass.plane)),
            fmt::format("{} → {} vertices", pass.before.count, pass.after.count));
    }
}

void draw_piece(const Theme& theme, const trace::PieceDetail& piece) {
    row(theme,
        "signed 2A",
        fmt::format(
            "{} px²", explain::number(static_cast<float>(piece.signed_doubled_area) / 65536.0F)
        ));
    row(theme, "facing", std::string{name_of(piece.facing)});
    if (!piece.setup) {
        return;
    }
    const PixelRect& box = piece.setup->bounds;
    row(theme,
        "pixel box",
        box.empty() ? std::string{"empty"}
                    : fmt::format(
                          "{} … {}",
                          explain::pixel({box.x0, box.y0}),
                          explain::pixel({box.x1 - 1, box.y1 - 1})
                      ));
    constexpr std::array names{"E01", "E12", "E20"};
    for (unsigned k = 0; k < 3; ++k) {
        const raster::EdgeFunction& e = piece.setup->edges[k];
        row(theme,
            names[k],
            fmt::format(
                "a {}  b {}\nc {}", explain::whole(e.a), explain::whole(e.b), explain::whole(e.c)
            ));
    }
}

} // namespace

void draw_vertex_tab(Context& context) {
    const Theme& theme = context.theme;
    if (const TriangleDetail* triangle = context.document.triangle_detail()) {
        choose_corner(context, *triangle);
    }
    const VertexDetail* vertex = current_vertex(context);
    if (vertex == nullptr) {
        empty_note(
            theme,
            "Step into the vertex stage or into a triangle (→, or click a stage of the strip) to "
            "see a vertex in all spaces."
        );
        return;
    }
    heading(theme, fmt::format("Vertex {} of object {}", vertex->vertex, vertex->object));
    draw_spaces(context, *vertex);
    ImGui::Dummy({0.0F, theme.units(1)});
    ImGui::Separator();
    const std::vector<explain::Formula> list = explain::vertex_formulas(*vertex);
    const int lit = lit_vertex_formula(context.document.player().current());
    if (hides_numbers(context.viewer)) {
        caption(theme, hidden_note);
    } else {
        draw_vertex_formulas(theme, list, lit);
    }
    draw_matrix(theme, "model: object to world", vertex->transforms.model.matrix);
    draw_matrix(theme, "view: world to eye", vertex->transforms.view.matrix);
    draw_matrix(theme, "projection: eye to clip", vertex->transforms.projection.matrix);
}

void draw_triangle_tab(Context& context) {
    const Theme& theme = context.theme;
    const TriangleDetail* triangle = context.document.triangle_detail();
    if (triangle == nullptr) {
        empty_note(
            theme,
            "Step into a triangle (→, or Ctrl+→) to see how it is clipped, which way it faces and "
            "its edge functions."
        );
        return;
    }
    const trace::Step& step = context.document.player().current();
    heading(theme, fmt::format("Triangle {} of object {}", triangle->triangle, triangle->object));
    row(theme,
        "vertices",
        fmt::format("{} {} {}", triangle->vertices.a, triangle->vertices.b, triangle->vertices.c));
    row(theme, "verdict", std::string{name_of(triangle->verdict)});
    caption(theme, std::string{named(triangle->verdict).explanation} + ".");
    if (step.kind < trace::StepKind::edge_test) {
        heading(theme, "This step");
        const auto list = explain::formulas(
            context.document.player().detail(), step, context.document.settings()
        );
        draw_step_formulas(theme, list);
    }
    heading(theme, "Outcodes");
    caption(theme, "a bit per plane and vertex: 1 is outside");
    const int planes = context.document.recording().frame->calls()[triangle->object].volume.count;
    draw_outcodes(theme, *triangle, planes);
    draw_passes(theme, *triangle);
    if (const trace::PieceDetail* piece = context.document.piece_detail()) {
        const bool several = triangle->pieces.size() > 1;
        const int number = step.has_piece() ? step.piece : 0;
        heading(
            theme,
            several ? fmt::format("Piece {}, of {} after clipping", number, triangle->pieces.size())
                    : std::string{"Area and edges"}
        );
        draw_piece(theme, *piece);
    }
}

} // namespace hs::viewer
