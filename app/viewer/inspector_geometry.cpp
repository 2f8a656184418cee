// The inspector's tabs for a vertex and for a triangle.
#include "app/viewer/formula_view.hpp"
#include "app/viewer/lesson_hiding.hpp"
#include "app/viewer/lesson_pointer.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/formulas.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace hs::viewer {
namespace {

using trace::TriangleDetail;
using trace::VertexDetail;

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

/// One line of the table of spaces: "clip" with x, y, z and w, in columns of equal width.
struct SpaceLine {
    std::string_view name;
    std::vector<std::string_view> quantities; ///< of its columns
    std::vector<float> values;
};

std::vector<SpaceLine> space_lines(const VertexDetail& vertex) {
    const auto four = [](const auto& v) { return std::vector{v.x, v.y, v.z, v.w}; };
    std::vector<SpaceLine> lines{
        {"object",
         {"object.x", "object.y", "object.z", "object.w"},
         four(math::to_vec4(vertex.work.object))},
        {"world",
         {"world.x", "world.y", "world.z", "world.w"},
         four(math::to_vec4(vertex.work.world))},
        {"eye", {"eye.x", "eye.y", "eye.z", "eye.w"}, four(math::to_vec4(vertex.work.eye))},
        {"clip", {"clip.x", "clip.y", "clip.z", "clip.w"}, four(math::to_vec4(vertex.work.clip))},
    };
    if (vertex.window.status != geometry::WindowStatus::at_eye) {
        const auto& ndc = vertex.window.ndc;
        const auto& window = vertex.window.window;
        lines.push_back({"ndc", {"ndc.x", "ndc.y", "ndc.z"}, {ndc.x, ndc.y, ndc.z}});
        lines.push_back(
            {"window", {"window.x", "window.y", "window.depth"}, {window.x, window.y, window.depth}}
        );
    }
    if (vertex.window.status == geometry::WindowStatus::placed) {
        lines.push_back(
            {"snapped",
             {"snapped.x", "snapped.y"},
             {to_pixels(vertex.window.fixed.x), to_pixels(vertex.window.fixed.y)}}
        );
    }
    return lines;
}

/// The same vertex in every space, one line each.
void draw_spaces(Context& context, const VertexDetail& vertex) {
    const Theme& theme = context.theme;
    const UseFont use{theme.fonts.small_mono};
    // Four columns beside the space's name, or below it where there is no room
    constexpr int name_width = 8; // characters
    const float advance = text_size(theme.fonts.small_mono, "0").x;
    const float start = ImGui::GetCursorPosX();
    const bool beside = ImGui::GetContentRegionAvail().x >= advance * (name_width + 4 * 10);
    const int column = beside ? 10 : 9;
    for (const SpaceLine& line : space_lines(vertex)) {
        ImGui::PushStyleColor(ImGuiCol_Text, theme[Tone::quiet]);
        ImGui::TextUnformatted(line.name.data(), line.name.data() + line.name.size());
        ImGui::PopStyleColor();
        if (beside) {
            ImGui::SameLine(start + advance * name_width);
        }
        const bool hidden = hides_space(context.viewer, line.name);
        std::string text;
        for (const float value : line.values) {
            text += fmt::format("{:>{}}", hidden ? "?" : explain::number(value), column - 1) + " ";
        }
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::TextUnformatted(text.c_str());
        for (std::size_t i = 0; i < line.quantities.size(); ++i) {
            if (points_at(context.viewer, line.quantities[i])) {
                const float x = at.x + advance * static_cast<float>(static_cast<int>(i) * column);
                draw_pointing_frame(
                    *ImGui::GetWindowDrawList(),
                    theme,
                    {x, at.y},
                    {x + advance * static_cast<float>(column - 1), ImGui::GetItemRectMax().y}
                );
            }
        }
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
void draw_vertex_formulas(
    const Context& context, const std::vector<explain::Formula>& list, int lit
) {
    if (lit >= 0 && lit < static_cast<int>(list.size())) {
        draw_formula(context, list[static_cast<std::size_t>(lit)], true);
    }
    for (int i = 0; i < static_cast<int>(list.size()); ++i) {
        if (i != lit) {
            draw_formula(context, list[static_cast<std::size_t>(i)], false);
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

void draw_line_piece(const Theme& theme, const raster::LineSetup& line) {
    row(theme, "pixels", fmt::format("{}", line.steps + 1));
    row(theme, "from", explain::pixel(line.first));
    row(theme, "to", explain::pixel(line.last));
    row(theme, "along", fmt::format("n = {} ({})", line.steps, line.steep ? "y" : "x"));
    row(theme, "across", fmt::format("m = {} ({})", line.rise, line.steep ? "x" : "y"));
}

void draw_piece(const Context& context, const trace::PieceDetail& piece) {
    const Theme& theme = context.theme;
    if (piece.line) {
        draw_line_piece(theme, *piece.line);
        return;
    }
    row(theme, "signed 2A", fmt::format("{} px²", explain::square_pixels(piece.signed_doubled_area))
    );
    tooltip(fmt::format("{} / 65 536 px²", explain::whole(piece.signed_doubled_area)));
    frame_if_pointed(context, {"signed area", "signed doubled area"});
    row(theme, "facing", std::string{name_of(piece.facing)});
    frame_if_pointed(context, {"facing"});
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
    frame_if_pointed(context, {"box pixels"});
    constexpr std::array names{"E01", "E12", "E20"};
    for (unsigned k = 0; k < 3; ++k) {
        const raster::EdgeFunction& e = piece.setup->edges[k];
        row(theme,
            names[k],
            fmt::format(
                "{}·x {} {}·y\n{} {} px²",
                explain::pixels(e.a),
                e.b < 0 ? "−" : "+",
                explain::pixels(std::abs(e.b)),
                e.c < 0 ? "−" : "+",
                explain::square_pixels(std::abs(e.c))
            ));
        tooltip(fmt::format(
            "x and y in pixels from the center of pixel (0, 0).\nIn whole numbers: a = {} / 256, "
            "b = {} / 256, c = {} / 65 536.",
            explain::whole(e.a),
            explain::whole(e.b),
            explain::whole(e.c)
        ));
        constexpr std::array parts{"", ".a", ".b", ".c", ".owns ties"};
        const bool pointed = std::ranges::any_of(parts, [&](const char* part) {
            return points_at(context.viewer, std::string{names[k]} + part);
        });
        if (pointed) {
            draw_pointing_frame(
                *ImGui::GetWindowDrawList(), theme, ImGui::GetItemRectMin(), ImGui::GetItemRectMax()
            );
        }
    }
}

} // namespace

void draw_vertex_tab(Context& context) {
    const Theme& theme = context.theme;
    if (const TriangleDetail* triangle = context.document.triangle_detail()) {
        choose_corner(context, *triangle);
    }
    const VertexDetail* vertex = context.document.vertex_detail(context.state.corner);
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
        draw_vertex_formulas(context, list, lit);
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
    std::string name = trace::primitive_name(step);
    name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    heading(theme, fmt::format("{} of object {}", name, triangle->object));
    const scene::TriangleIndices& v = triangle->vertices;
    row(theme,
        "vertices",
        step.of_triangle()                             ? fmt::format("{} {} {}", v.a, v.b, v.c)
        : step.primitive == scene::PrimitiveKind::line ? fmt::format("{} {}", v.a, v.b)
                                                       : fmt::format("{}", v.a));
    row(theme, "verdict", std::string{name_of(triangle->verdict)});
    frame_if_pointed(context, {"verdict"});
    caption(theme, std::string{named(triangle->verdict).explanation} + ".");
    if (step.kind < trace::StepKind::edge_test) {
        const auto list = explain::formulas(
            context.document.player().detail(), step, context.document.settings()
        );
        if (!list.empty()) {
            heading(theme, "This step");
        }
        draw_step_formulas(context, list);
    }
    heading(theme, "Outcodes");
    caption(theme, "a bit per plane and vertex: 1 is outside");
    frame_if_pointed(context, {"outcode"});
    const int planes = context.document.recording().frame->calls()[triangle->object].volume.count;
    draw_outcodes(theme, *triangle, planes);
    draw_passes(theme, *triangle);
    if (const trace::PieceDetail* piece = context.document.piece_detail()) {
        const bool several = triangle->pieces.size() > 1;
        const int number = step.has_piece() ? step.piece : 0;
        heading(
            theme,
            several ? fmt::format("Piece {}, of {} after clipping", number, triangle->pieces.size())
                    : std::string{piece->line ? "The walk" : "Area and edges"}
        );
        draw_piece(context, *piece);
    }
}

} // namespace hs::viewer
