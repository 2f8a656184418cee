#include "core/explain/formulas.hpp"

#include "core/explain/geometry_formulas.hpp"
#include "core/explain/lighting.hpp"
#include "core/explain/line.hpp"
#include "core/explain/numbers.hpp"
#include "core/explain/samples.hpp"
#include "core/explain/sentence.hpp"
#include "core/explain/traversal.hpp"

#include <fmt/format.h>

#include <array>

namespace hs::explain {
namespace {

using trace::StepKind;

constexpr std::array<const char*, 3> edge_names{"E01", "E12", "E20"};

// ---- fragment

Formula weights_formula(const trace::FragmentDetail& fragment, const raster::TriangleSetup& setup) {
    const raster::EdgeValues& e = fragment.edges;
    const auto& weights = fragment.fragment.barycentric;
    return {
        "barycentric weights in the window",
        "λ1 = E20 / 2A,  λ2 = E01 / 2A,  λ0 = 1 − λ1 − λ2",
        fmt::format(
            "λ1 = {} / {}\nλ2 = {} / {}",
            square_pixels(e[2]),
            square_pixels(setup.doubled_area),
            square_pixels(e[0]),
            square_pixels(setup.doubled_area)
        ),
        point(weights[0], weights[1], weights[2]),
        {"λ0", "λ1", "λ2"}};
}

Formula depth_formula(const trace::FragmentDetail& fragment, const trace::PieceDetail& piece) {
    const auto& weights = fragment.fragment.barycentric;
    const auto& v = piece.window;
    return {
        "depth, linear in the window",
        "z = z0 + λ1·(z1 − z0) + λ2·(z2 − z0)",
        fmt::format(
            "{} + {}·({} − {})\n+ {}·({} − {})",
            number(v[0].window.depth),
            number(weights[1]),
            number(v[1].window.depth),
            number(v[0].window.depth),
            number(weights[2]),
            number(v[2].window.depth),
            number(v[0].window.depth)
        ),
        number(fragment.fragment.depth),
        {"depth"}};
}

Formula
perspective_formula(const trace::FragmentDetail& fragment, const trace::PieceDetail& piece) {
    const auto& weights = fragment.fragment.barycentric;
    const auto& corrected = fragment.fragment.barycentric_clip;
    const auto& v = piece.window;
    return {
        "weights corrected for perspective",
        "b_i = λ_i·(1/w_i) / Σ λ_j·(1/w_j)",
        fmt::format(
            "1/w = {}, {}, {}\nλ = {}",
            number(v[0].inv_w),
            number(v[1].inv_w),
            number(v[2].inv_w),
            point(weights[0], weights[1], weights[2])
        ),
        point(corrected[0], corrected[1], corrected[2]),
        {"b0", "b1", "b2", "1/w"}};
}

Formula test_formula(const pipeline::DepthTest& test) {
    const auto [depth, stored] = compared(test.depth, test.stored);
    const std::string_view sign = symbol(test.op);
    return {
        fmt::format("depth test: {}", name_of(test.op)),
        sign.empty() ? std::string{name_of(test.op)} : fmt::format("z {} stored", sign),
        fmt::format("{} {} {}", depth, sign.empty() ? name_of(test.op) : sign, stored),
        test.passed ? "true: passes" : "false: fails",
        {"stored depth", "passes depth test"}};
}

Formula merge_formula(const pipeline::Merge& merge, const scene::Settings& settings) {
    if (settings.samples > 1) {
        return samples_merge_formula(merge);
    }
    if (!merge.blended) {
        return {"write", "pixel = source", point(merge.source), point(merge.after)};
    }
    return {
        "blend over",
        "pixel = source·a + before·(1 − a)",
        fmt::format(
            "{}·{}\n+ {}·{}",
            point(merge.source),
            number(merge.source.a),
            point(merge.before),
            number(1.0F - merge.source.a)
        ),
        point(merge.after)};
}

int corner_count(scene::PrimitiveKind kind) {
    return kind == scene::PrimitiveKind::triangle ? 3 : kind == scene::PrimitiveKind::line ? 2 : 1;
}

std::vector<Formula> triangle_step_formulas(
    const trace::TriangleDetail& triangle, const trace::Step& step, const scene::Settings& settings
) {
    if (step.kind == StepKind::outcodes) {
        return outcode_formulas(triangle, settings);
    }
    if (step.kind == StepKind::clip_plane) {
        return clip_formulas(triangle, step.plane, settings);
    }
    const auto index = static_cast<std::size_t>(step.piece);
    if (index >= triangle.pieces.size()) {
        return {};
    }
    const trace::PieceDetail& piece = triangle.pieces[index];
    std::vector<Formula> list;
    for (int k = 0; k < corner_count(triangle.primitive.kind); ++k) {
        const geometry::WindowVertex& v = piece.window[static_cast<unsigned>(k)];
        if (step.kind == StepKind::divide) {
            list.push_back(inv_w_formula(k, v));
        } else if (step.kind == StepKind::viewport) {
            list.push_back(snap_formula(k, v));
        }
    }
    if (step.kind == StepKind::facing && !piece.determinant) {
        list.push_back(facing_formula(piece));
    } else if (step.kind == StepKind::setup && piece.planes) {
        list = plane_setup_formulas(*piece.planes);
    } else if (step.kind == StepKind::setup && piece.setup) {
        list = setup_formulas(*piece.setup);
    } else if (step.kind == StepKind::setup && piece.line) {
        list = line_setup_formulas(*piece.line, settings.line_algorithm);
    }
    return list;
}

/// The one formula a fragment's step computes; two for interpolation.
std::vector<Formula> only_of_step(
    std::vector<Formula> all,
    const trace::FragmentDetail& fragment,
    StepKind kind,
    const scene::Settings& settings
) {
    if (kind == StepKind::interpolate) {
        const auto before_test = [](const Formula& f) {
            return f.title.find("weights") != std::string::npos ||
                   f.title.find("along the line") != std::string::npos ||
                   f.title.find("linear in the window") != std::string::npos;
        };
        std::vector<Formula> list;
        for (Formula& formula : all) {
            if (before_test(formula)) {
                list.push_back(std::move(formula));
            }
        }
        return list;
    }
    if (kind == StepKind::shade && fragment.shaded) {
        if (fragment.lit) {
            return lighting_formulas(*fragment.shaded->terms, *fragment.lit);
        }
        return {
            {"surface color",
             "color = interpolated color × texel",
             "",
             point(fragment.shaded->color)}};
    }
    if (kind == StepKind::depth_test && fragment.depth_test) {
        return {test_formula(*fragment.depth_test)};
    }
    if (kind == StepKind::merge && fragment.merge) {
        return {merge_formula(*fragment.merge, settings)};
    }
    return {};
}

const trace::PieceDetail* piece_of(const trace::StepDetail& detail, const trace::Step& step) {
    if (!detail.triangle ||
        static_cast<std::size_t>(step.piece) >= detail.triangle->pieces.size()) {
        return nullptr;
    }
    return &detail.triangle->pieces[static_cast<std::size_t>(step.piece)];
}

} // namespace

std::vector<Formula>
edge_formulas(const raster::TriangleSetup& setup, const trace::VisitDetail& visit) {
    std::vector<Formula> list;
    for (unsigned k = 0; k < 3; ++k) {
        const raster::EdgeFunction& e = setup.edges[k];
        const std::int64_t value = visit.edges[k];
        const bool owned = value + setup.top_left_bias[k] >= 0;
        list.push_back(
            {fmt::format("{} at pixel {}", edge_names[k], pixel(visit.pixel)),
             e.owns_ties() ? "E = a·x + b·y + c, inside iff E ≥ 0 (top-left edge)"
                           : "E = a·x + b·y + c, inside iff E > 0",
             fmt::format(
                 "{}·{} + {}·{} + {}",
                 pixels(e.a),
                 visit.pixel.x,
                 pixels(e.b),
                 visit.pixel.y,
                 square_pixels(e.c)
             ),
             fmt::format(
                 "{} px² ({} / 65 536): {}",
                 square_pixels(value),
                 whole(value),
                 owned ? "inside" : "outside"
             ),
             {edge_names[k], "covered"}}
        );
    }
    return list;
}

std::vector<Formula> fragment_formulas(
    const trace::FragmentDetail& fragment,
    const trace::PieceDetail& piece,
    const scene::Settings& settings
) {
    std::vector<Formula> list;
    if (piece.setup) {
        list.push_back(weights_formula(fragment, *piece.setup));
        list.push_back(depth_formula(fragment, piece));
    }
    if (piece.setup && settings.interpolation == scene::InterpolationKind::perspective) {
        list.push_back(perspective_formula(fragment, piece));
    }
    if (piece.line) {
        list = line_fragment_formulas(fragment, piece);
    }
    if (fragment.lit) {
        const std::vector<Formula> lighting =
            lighting_formulas(*fragment.shaded->terms, *fragment.lit);
        list.insert(list.end(), lighting.begin(), lighting.end());
    }
    if (fragment.depth_test) {
        list.push_back(test_formula(*fragment.depth_test));
    }
    if (fragment.merge) {
        list.push_back(merge_formula(*fragment.merge, settings));
    }
    return list;
}

namespace {

std::vector<Formula> vertex_step_formulas(const trace::VertexDetail& vertex, StepKind kind) {
    if (kind == StepKind::vertex_light) {
        return lighting_formulas(*vertex.work.terms, *vertex.lit);
    }
    const std::vector<Formula> all = vertex_formulas(vertex);
    const auto index =
        static_cast<std::size_t>(kind) - static_cast<std::size_t>(StepKind::vertex_world);
    return index < all.size() ? std::vector{all[index]} : std::vector<Formula>{};
}

std::vector<Formula> edge_test_formulas(
    const trace::StepDetail& detail,
    const trace::Step& step,
    const trace::PieceDetail* piece,
    const scene::Settings& settings
) {
    if (!detail.visit || piece == nullptr || !piece->setup) {
        return {};
    }
    if (settings.sampling == scene::Sampling::conservative) {
        return square_formulas(*piece->setup, step.pixel, detail.visit->edges);
    }
    std::vector<Formula> running = running_edge_formulas(detail, step, settings.traversal);
    return running.empty() ? edge_formulas(*piece->setup, *detail.visit) : running;
}

std::vector<Formula> fragment_step_formulas(
    const trace::StepDetail& detail,
    const trace::PieceDetail& piece,
    StepKind kind,
    const scene::Settings& settings
) {
    if (kind == StepKind::shade) {
        std::vector<Formula> mixed =
            mixed_color_formulas(*detail.triangle, *detail.fragment, settings);
        if (!mixed.empty()) {
            return mixed;
        }
    }
    return only_of_step(
        fragment_formulas(*detail.fragment, piece, settings), *detail.fragment, kind, settings
    );
}

/// Of the steps between setup and fragments.
std::optional<std::vector<Formula>> traversal_step_formulas(
    const trace::StepDetail& detail,
    const trace::Step& step,
    const trace::PieceDetail& piece,
    const scene::Settings& settings
) {
    if (step.kind == StepKind::sample_test) {
        return sample_formulas(
            *piece.setup, step, detail.samples[static_cast<std::size_t>(step.sample)]
        );
    }
    if (step.kind == StepKind::line_step) {
        return line_step_formulas(*piece.line, *detail.traversal->line, settings.line_algorithm);
    }
    if (step.kind == StepKind::plane_test) {
        return plane_formulas(step, *piece.planes, *detail.traversal->planes);
    }
    if (detail.traversal && !step.has_pixel() && piece.setup) {
        return traversal_formulas(*detail.traversal, step, *piece.setup);
    }
    return std::nullopt;
}

} // namespace

std::vector<Formula> formulas(
    const trace::StepDetail& detail, const trace::Step& step, const scene::Settings& settings
) {
    if (step.in_vertex_stage() && detail.vertex) {
        return vertex_step_formulas(*detail.vertex, step.kind);
    }
    if (detail.resolve) {
        return {resolve_formula(*detail.resolve)};
    }
    const trace::PieceDetail* const piece = piece_of(detail, step);
    if (step.kind == StepKind::edge_test) {
        return edge_test_formulas(detail, step, piece, settings);
    }
    if (piece != nullptr) {
        if (auto list = traversal_step_formulas(detail, step, *piece, settings)) {
            return *std::move(list);
        }
        if (step.in_fragment() && detail.fragment) {
            return fragment_step_formulas(detail, *piece, step.kind, settings);
        }
    }
    return detail.triangle ? triangle_step_formulas(*detail.triangle, step, settings)
                           : std::vector<Formula>{};
}

} // namespace hs::explain
