// The stages before traversal: transforms, clipping, divide, snapping, facing, setup.
#include "core/explain/geometry_formulas.hpp"

#include "core/explain/clip_story.hpp"
#include "core/explain/lighting.hpp"
#include "core/explain/numbers.hpp"
#include "core/explain/sentence.hpp"

#include <fmt/format.h>

#include <array>

namespace hs::explain {
namespace {

constexpr std::array<const char*, 3> edge_names{"E01", "E12", "E20"};

/// One line per row of the matrix: "x = 0.5000 · 1.0000 + … ".
std::string rows(const glm::mat4& m, const glm::vec4& v) {
    constexpr std::string_view axes = "xyzw";
    std::string text;
    for (int r = 0; r < 4; ++r) {
        text += fmt::format(
            "{}{} = {}·{} + {}·{} + {}·{} + {}·{}",
            r == 0 ? "" : "\n",
            axes[static_cast<std::size_t>(r)],
            number(m[0][r]),
            number(v.x),
            number(m[1][r]),
            number(v.y),
            number(m[2][r]),
            number(v.z),
            number(m[3][r]),
            number(v.w)
        );
    }
    return text;
}

template <typename From, typename To>
Formula transform_formula(
    const char* title,
    const char* symbolic,
    std::string_view quantity,
    const math::Transform<From, To>& transform,
    const math::Position<From>& from,
    const math::Position<To>& to
) {
    return {
        title,
        symbolic,
        rows(transform.matrix, math::to_vec4(from)),
        point(math::to_vec4(to)),
        {quantity}};
}

} // namespace

// ---- vertex stage

Formula divide_formula(const math::ClipPosition& clip, const geometry::WindowVertex& v) {
    return {
        "perspective divide",
        "p_ndc = p_clip · (1/w)",
        fmt::format(
            "1/w = 1 / {} = {}\nx = {}·{}\ny = {}·{}\nz = {}·{}",
            number(clip.w),
            number(v.inv_w),
            number(clip.x),
            number(v.inv_w),
            number(clip.y),
            number(v.inv_w),
            number(clip.z),
            number(v.inv_w)
        ),
        point(v.ndc.x, v.ndc.y, v.ndc.z),
        {"ndc", "inv_w"}};
}

Formula inv_w_formula(int vertex, const geometry::WindowVertex& v) {
    return {
        fmt::format("divide vertex {} by w", vertex),
        "p_ndc = p_clip · (1/w)",
        fmt::format("1/w = {}", number(v.inv_w)),
        point(v.ndc.x, v.ndc.y, v.ndc.z),
        {"ndc", "inv_w"}};
}

Formula snap_formula(int vertex, const geometry::WindowVertex& v) {
    return {
        fmt::format("vertex {} in the window", vertex),
        "x = c_x + (W/2)·x_ndc,  y = c_y − (H/2)·y_ndc, snapped to 1/256 px",
        fmt::format(
            "x_ndc = {}, y_ndc = {}\nx = {} → {}\ny = {} → {}",
            number(v.ndc.x),
            number(v.ndc.y),
            number(v.window.x),
            number(to_pixels(v.fixed.x)),
            number(v.window.y),
            number(to_pixels(v.fixed.y))
        ),
        fmt::format(
            "({}, {}) depth {}",
            number(to_pixels(v.fixed.x)),
            number(to_pixels(v.fixed.y)),
            number(v.window.depth)
        ),
        {"window", "snapped", "fixed"}};
}

// ---- clip

std::vector<Formula>
outcode_formulas(const trace::TriangleDetail& triangle, const scene::Settings& settings) {
    const geometry::ClipVolume volume =
        geometry::clip_volume(settings, triangle.corners[0].transforms.projection.matrix);
    std::vector<Formula> list;
    for (int k = 0; k < volume.count; ++k) {
        const auto plane = static_cast<geometry::ClipPlane>(k);
        std::array<float, 3> d{};
        int outside = 0;
        for (unsigned corner = 0; corner < 3; ++corner) {
            d[corner] = math::signed_distance(
                volume.planes[static_cast<unsigned>(k)],
                math::to_vec4(triangle.corners[corner].work.clip)
            );
            outside += math::inside(d[corner]) ? 0 : 1;
        }
        list.push_back(
            {fmt::format("distance to plane {}", name_of(plane)),
             fmt::format(
                 "d = {}, inside iff d ≥ 0", plane_distance(plane, settings.depth_convention)
             ),
             fmt::format("v0 {}\nv1 {}\nv2 {}", number(d[0]), number(d[1]), number(d[2])),
             outside == 0   ? "all inside"
             : outside == 3 ? "all outside"
                            : fmt::format("{} of 3 outside", outside),
             {"outcode"}}
        );
    }
    return list;
}

std::vector<Formula> clip_formulas(
    const trace::TriangleDetail& triangle,
    geometry::ClipPlane plane,
    const scene::Settings& settings
) {
    std::vector<Formula> list;
    for (const ClipPassStory& pass : clip_story(triangle, settings)) {
        if (pass.plane != plane) {
            continue;
        }
        for (const ClipCut& cut : pass.cuts) {
            list.push_back(
                {fmt::format("edge {}–{} meets plane {}", cut.inside, cut.outside, name_of(plane)),
                 "t = d_in / (d_in − d_out),  p = p_in + t·(p_out − p_in)",
                 fmt::format(
                     "t = {} / ({} − {}) = {}",
                     number(cut.d_inside),
                     number(cut.d_inside),
                     number(cut.d_outside),
                     number(cut.t)
                 ),
                 point(math::to_vec4(cut.made.position))}
            );
        }
    }
    return list;
}

// ---- cull and setup

Formula facing_formula(const trace::PieceDetail& piece) {
    const auto& v = piece.window;
    return {
        "twice the signed area",
        "2A = (x2 − x0)·(y1 − y0) − (y2 − y0)·(x1 − x0), snapped, y down",
        fmt::format(
            "({} − {})·({} − {})\n− ({} − {})·({} − {})",
            number(to_pixels(v[2].fixed.x)),
            number(to_pixels(v[0].fixed.x)),
            number(to_pixels(v[1].fixed.y)),
            number(to_pixels(v[0].fixed.y)),
            number(to_pixels(v[2].fixed.y)),
            number(to_pixels(v[0].fixed.y)),
            number(to_pixels(v[1].fixed.x)),
            number(to_pixels(v[0].fixed.x))
        ),
        fmt::format(
            "{} px²: {}",
            square_pixels(piece.signed_doubled_area),
            piece.signed_doubled_area > 0   ? "counterclockwise"
            : piece.signed_doubled_area < 0 ? "clockwise"
                                            : "no area"
        ),
        {"signed area", "signed doubled area", "facing"}};
}

std::vector<Formula> setup_formulas(const raster::TriangleSetup& setup) {
    std::vector<Formula> list;
    for (unsigned k = 0; k < 3; ++k) {
        const raster::EdgeFunction& e = setup.edges[k];
        list.push_back(
            {fmt::format("edge function {}", edge_names[k]),
             "E(x, y) = a·x + b·y + c, x and y in pixels from the center of pixel (0, 0)",
             fmt::format(
                 "a = {} px, b = {} px\nc = {} px²", pixels(e.a), pixels(e.b), square_pixels(e.c)
             ),
             e.owns_ties() ? "top or left edge: owns pixel centers on it"
                           : "neither top nor left: leaves them to its neighbor",
             {edge_names[k]}}
        );
    }
    return list;
}

std::vector<Formula> vertex_formulas(const trace::VertexDetail& vertex) {
    const pipeline::VertexWork& work = vertex.work;
    const pipeline::Transforms& t = vertex.transforms;
    std::vector<Formula> list{
        transform_formula(
            "object to world",
            "p_world = M_model · p_object",
            "world",
            t.model,
            work.object,
            work.world
        ),
        transform_formula(
            "world to eye", "p_eye = M_view · p_world", "eye", t.view, work.world, work.eye
        ),
        transform_formula(
            "eye to clip",
            "p_clip = M_projection · p_eye",
            "clip",
            t.projection,
            work.eye,
            work.clip
        ),
    };
    if (vertex.lit) {
        const std::vector<Formula> lighting = lighting_formulas(*work.terms, *vertex.lit);
        list.insert(list.end(), lighting.begin(), lighting.end());
    }
    if (vertex.window.status == geometry::WindowStatus::placed) {
        list.push_back(divide_formula(work.clip, vertex.window));
        list.push_back(snap_formula(static_cast<int>(vertex.vertex), vertex.window));
    }
    return list;
}

} // namespace hs::explain
