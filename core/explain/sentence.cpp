#include "core/explain/sentence.hpp"

#include "core/explain/line.hpp"
#include "core/explain/numbers.hpp"
#include "core/explain/order.hpp"
#include "core/explain/samples.hpp"
#include "core/explain/sweep.hpp"
#include "core/explain/traversal.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hs::explain {
namespace {

using trace::Step;
using trace::StepDetail;
using trace::StepKind;

/// "triangle 12", "triangle 12 piece 1"; with the object where there is more than one.
std::string triangle_name(const trace::Recording& recording, const Step& step) {
    std::string name = trace::primitive_name(step);
    if (recording.objects.size() > 1) {
        name += fmt::format(" of object {}", step.object);
    }
    if (step.has_piece() && (step.clipped || step.part) && step.of_triangle()) {
        name += fmt::format(", piece {}", step.piece);
    }
    return name;
}

std::string fragment_name(const trace::Recording& recording, const Step& step) {
    const std::string sample =
        step.sample < 0 ? std::string{} : fmt::format("Sample {} of fragment", step.sample);
    return fmt::format(
        "{} {} of {}",
        sample.empty() ? "Fragment" : sample,
        pixel(step.pixel),
        triangle_name(recording, step)
    );
}

std::string vertex_sentence(const Step& step, const trace::VertexDetail& detail) {
    const std::string who = fmt::format("Vertex {} of object {}", step.vertex, step.object);
    const pipeline::VertexWork& work = detail.work;
    if (step.kind == StepKind::vertex_world) {
        const std::string place = point(math::to_vec4(work.world));
        return fmt::format("{} moves to its place in the world, {}.", who, place);
    }
    if (step.kind == StepKind::vertex_eye) {
        return fmt::format("{}, seen from the eye, is {}.", who, point(math::to_vec4(work.eye)));
    }
    if (step.kind == StepKind::vertex_clip) {
        const std::string place = point(math::to_vec4(work.clip));
        return fmt::format("{} is projected to clip space: {}.", who, place);
    }
    const glm::vec4 color = work.varyings.color();
    return fmt::format("{} is lit: color {}.", who, point(color.r, color.g, color.b));
}

std::string outcodes_sentence(const std::string& who, const trace::TriangleDetail& triangle) {
    const unsigned all = triangle.outcodes[0] & triangle.outcodes[1] & triangle.outcodes[2];
    const unsigned any = triangle.outcodes[0] | triangle.outcodes[1] | triangle.outcodes[2];
    std::string planes;
    for (unsigned k = 0; k < geometry::max_clip_planes; ++k) {
        if (((all != 0 ? all : any) >> k & 1U) != 0) {
            planes += planes.empty() ? "" : ", ";
            planes += name_of(static_cast<geometry::ClipPlane>(k));
        }
    }
    if (any == 0) {
        return fmt::format("All of {} lies inside the view volume: nothing to clip.", who);
    }
    if (all != 0) {
        return fmt::format("All of {} lies outside plane {}: it is invisible.", who, planes);
    }
    return fmt::format("The {} has vertices outside: {}; it must be clipped.", who, planes);
}

std::string
clip_sentence(const std::string& who, const Step& step, const trace::TriangleDetail& triangle) {
    for (const trace::ClipPass& pass : triangle.passes) {
        if (pass.plane == step.plane && !step.of_triangle()) {
            return fmt::format(
                "Plane {} cuts {}: {}.",
                name_of(step.plane),
                who,
                pass.after.count == 0 ? "nothing is left" : "an end moves onto the plane"
            );
        }
        if (pass.plane == step.plane) {
            return fmt::format(
                "Plane {} cuts {}: a polygon of {} vertices becomes one of {}.",
                name_of(step.plane),
                who,
                pass.before.count,
                pass.after.count
            );
        }
    }
    return fmt::format("Plane {} cuts {}.", name_of(step.plane), who);
}

/// Where a vertex has no place in the window, there is no area either.
std::string determinant_sentence(const std::string& who, const trace::PieceDetail& piece) {
    const std::string value = fmt::format(
        "the determinant of its vertices is {}", number(static_cast<float>(*piece.determinant))
    );
    if (piece.facing != geometry::TriangleVerdict::drawn) {
        return fmt::format("The {} is {}: {}.", who, name_of(piece.facing), value);
    }
    return fmt::format(
        "The {} reaches behind the eye; it is seen {} and stays: {}.",
        who,
        *piece.determinant < 0.0 ? "counterclockwise" : "clockwise",
        value
    );
}

std::string
facing_sentence(const std::string& who, const trace::PieceDetail& piece, scene::Winding front) {
    if (piece.determinant) {
        return determinant_sentence(who, piece);
    }
    const std::int64_t area = piece.signed_doubled_area;
    const std::string value = fmt::format("twice its signed area is {} px²", square_pixels(area));
    if (area == 0) {
        return fmt::format("The {} encloses no area on the snapped grid: discarded.", who);
    }
    if (piece.facing != geometry::TriangleVerdict::drawn) {
        return fmt::format("The {} is {}, culled: {}.", who, name_of(piece.facing), value);
    }
    const bool is_front = geometry::is_front(area, front);
    return fmt::format(
        "The {} shows its {} ({}) and stays: {}.",
        who,
        is_front ? "front" : "back",
        area > 0 ? "counterclockwise" : "clockwise",
        value
    );
}

std::string setup_sentence(const std::string& who, const raster::TriangleSetup& setup) {
    const PixelRect& box = setup.bounds;
    if (box.empty()) {
        return fmt::format("Three edge functions of {} are ready; no pixel center is near.", who);
    }
    return fmt::format(
        "Three edge functions of {} are ready; its box runs from pixel {} to {}.",
        who,
        pixel({box.x0, box.y0}),
        pixel({box.x1 - 1, box.y1 - 1})
    );
}

std::string edge_sentence(const std::string& who, const Step& step, const StepDetail& detail) {
    if (step.covered) {
        return fmt::format(
            "Pixel {} lies inside all three edges of {}: a fragment is born.",
            pixel(step.pixel),
            who
        );
    }
    std::string edges;
    if (detail.visit) {
        constexpr std::array names{"E01", "E12", "E20"};
        for (unsigned k = 0; k < 3; ++k) {
            const std::int64_t e = detail.visit->edges[k];
            if (e < 0) {
                edges += fmt::format(
                    "{}{} = {} px² < 0", edges.empty() ? "" : ", ", names[k], square_pixels(e)
                );
            }
        }
    }
    if (edges.empty()) {
        edges = "it lies exactly on an edge that a neighbor owns";
    }
    return fmt::format("Pixel {} lies outside {}: {}.", pixel(step.pixel), who, edges);
}

std::string
depth_sentence(const std::string& who, const Step& step, const trace::FragmentDetail& fragment) {
    const char* const verdict = step.passed ? "passes" : "fails";
    if (!fragment.depth_test) {
        return fmt::format("{} {} the depth test.", who, verdict);
    }
    const pipeline::DepthTest& test = *fragment.depth_test;
    if (symbol(test.op).empty()) {
        return fmt::format("{} {} the depth test: {}.", who, verdict, name_of(test.op));
    }
    const auto [depth, stored] = compared(test.depth, test.stored);
    return fmt::format(
        "{} {} the depth test: {} {} {} is {}.",
        who,
        verdict,
        depth,
        symbol(test.op),
        stored,
        test.passed
    );
}

std::string
fragment_sentence(const std::string& who, const Step& step, const trace::FragmentDetail& fragment) {
    if (step.kind == StepKind::interpolate) {
        const auto& weights = fragment.fragment.barycentric;
        return fmt::format(
            "{} gets weights {} and depth {}.",
            who,
            point(weights[0], weights[1], weights[2]),
            number(fragment.fragment.depth)
        );
    }
    if (step.kind == StepKind::shade && fragment.shaded) {
        return fmt::format("{} is shaded: color {}.", who, point(fragment.shaded->color));
    }
    if (step.kind == StepKind::scissor_test) {
        const char* const side = step.passed ? "inside" : "outside";
        return fmt::format("{} lies {} the scissor rectangle.", who, side);
    }
    if (step.kind == StepKind::closed_test) {
        return step.passed ? fmt::format("{} finds its pixel open.", who)
                           : fmt::format("{} finds its pixel closed by a nearer triangle.", who);
    }
    if (step.kind == StepKind::depth_test) {
        return depth_sentence(who, step, fragment);
    }
    if (!fragment.merge) {
        return fmt::format("{} reaches its pixel.", who);
    }
    const glm::vec4& after = fragment.merge->after;
    return fmt::format(
        "{} {}: the color becomes {}{}.",
        who,
        fragment.merge->blended ? "is blended into its pixel" : "is written",
        point(after.r, after.g, after.b),
        fragment.merge->depth_written ? fmt::format(", the depth {}", number(fragment.merge->depth))
                                      : std::string{}
    );
}

std::string piece_sentence(
    const std::string& who, const Step& step, const trace::PieceDetail& piece, scene::Winding front
) {
    const geometry::WindowVertex& v = piece.window[0];
    if (step.kind == StepKind::divide) {
        return fmt::format(
            "The vertices of {} are divided by w; the first lands at NDC {}.",
            who,
            point(v.ndc.x, v.ndc.y, v.ndc.z)
        );
    }
    if (step.kind == StepKind::viewport) {
        return fmt::format(
            "The vertices of {} land in the window; the first at x {}, y {}, depth {}.",
            who,
            number(v.window.x),
            number(v.window.y),
            number(v.window.depth)
        );
    }
    if (step.kind == StepKind::facing) {
        return facing_sentence(who, piece, front);
    }
    if (piece.line) {
        return line_setup_sentence(who, *piece.line);
    }
    if (piece.planes && !piece.setup) {
        return fmt::format("Three planes through the eye and the edges of {} are ready.", who);
    }
    return piece.setup ? setup_sentence(who, *piece.setup) : fmt::format("Setting up {}.", who);
}

std::string triangle_sentence(
    const trace::Recording& recording, const Step& step, const trace::TriangleDetail& triangle
) {
    const std::string who = triangle_name(recording, step);
    if (step.kind == StepKind::outcodes) {
        return outcodes_sentence(who, triangle);
    }
    if (step.kind == StepKind::clip_plane) {
        return clip_sentence(who, step, triangle);
    }
    const auto piece = static_cast<std::size_t>(step.piece);
    if (piece >= triangle.pieces.size()) {
        return fmt::format("{} at {}.", name_of(step.kind), who);
    }
    const scene::Object& object = recording.scene().objects[step.object];
    const scene::Winding front = scene::object_settings(recording.scene(), object).front_face;
    return piece_sentence(who, step, triangle.pieces[piece], front);
}

std::string end_sentence(const trace::Recording& recording) {
    const trace::Counters& all = recording.counters;
    const bool only_triangles =
        std::ranges::all_of(recording.scene().objects, [](const scene::Object& object) {
            return object.mesh->lines.empty() && object.mesh->points.empty();
        });
    return fmt::format(
        "The frame is finished: {} {} made {} fragments, {} of them were written.",
        whole(static_cast<std::int64_t>(all.triangles)),
        only_triangles ? "triangles" : "triangles, lines and points",
        whole(static_cast<std::int64_t>(all.fragments)),
        whole(static_cast<std::int64_t>(all.fates[0]))
    );
}

} // namespace

std::string_view symbol(scene::CompareOp op) {
    switch (op) {
    case scene::CompareOp::less: return "<";
    case scene::CompareOp::lequal: return "≤";
    case scene::CompareOp::equal: return "=";
    case scene::CompareOp::gequal: return "≥";
    case scene::CompareOp::greater: return ">";
    case scene::CompareOp::notequal: return "≠";
    case scene::CompareOp::never:
    case scene::CompareOp::always: return "";
    }
    HS_CHECK(false, "every compare op is handled");
    return "";
}

std::string sentence(const trace::Player& player) {
    const trace::Recording& recording = player.recording();
    const Step& step = player.current();
    if (step.kind == StepKind::start) {
        return "The framebuffer is cleared; nothing has been drawn yet.";
    }
    if (step.kind == StepKind::end) {
        return end_sentence(recording);
    }
    if (step.kind == StepKind::resolve) {
        return resolve_sentence(player);
    }
    if (step.kind == StepKind::order) {
        return order_sentence(recording, step.event);
    }
    if (step.kind == StepKind::sweep) {
        return sweep_sentence(recording, trace::sweep_detail(recording, step));
    }
    const StepDetail& detail = player.detail();
    if (step.in_vertex_stage() && detail.vertex) {
        return vertex_sentence(step, *detail.vertex);
    }
    if (step.kind == StepKind::sample_test) {
        return sample_sentence(triangle_name(recording, step), step, detail.samples);
    }
    if (step.kind == StepKind::edge_test &&
        recording.settings().sampling == scene::Sampling::conservative) {
        const auto& piece = detail.triangle->pieces[static_cast<std::size_t>(step.piece)];
        return square_sentence(
            triangle_name(recording, step), step, *piece.setup, detail.visit->edges
        );
    }
    if (step.kind == StepKind::edge_test) {
        return edge_sentence(triangle_name(recording, step), step, detail);
    }
    if (detail.traversal && !step.in_fragment()) {
        const auto& piece = detail.triangle->pieces[static_cast<std::size_t>(step.piece)];
        const std::string who = triangle_name(recording, step);
        if (step.kind == StepKind::line_step) {
            return line_step_sentence(
                who, *piece.line, *detail.traversal->line, recording.settings().line_algorithm
            );
        }
        if (step.kind == StepKind::plane_test) {
            return plane_sentence(who, step, *piece.planes, *detail.traversal->planes);
        }
        return traversal_sentence(who, step, *detail.traversal, *piece.setup);
    }
    if (step.kind == StepKind::merge && recording.samples.active()) {
        return samples_merge_sentence(
            fragment_name(recording, step),
            recording.fragments[step.fragment],
            detail.fragment->merge && detail.fragment->merge->blended
        );
    }
    if (step.in_fragment() && detail.fragment) {
        return fragment_sentence(fragment_name(recording, step), step, *detail.fragment);
    }
    if (detail.triangle) {
        return triangle_sentence(recording, step, *detail.triangle);
    }
    return trace::step_path(step) + ".";
}

} // namespace hs::explain
