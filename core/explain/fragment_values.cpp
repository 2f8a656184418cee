// The values of interpolation and shading.
#include "core/explain/value_list.hpp"
#include "core/math/interpolate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hs::explain {
namespace {

using trace::StepKind;

const Operation reciprocal{"1 / ", 4, UnitRule::none, [](std::span<const Number> n) -> Number {
                               return math::reciprocal(std::get<float>(n[0]));
                           }};
const Operation within_0_1{"clamp", 0, UnitRule::none, [](std::span<const Number> n) -> Number {
                               return std::clamp(std::get<double>(n[0]), 0.0, 1.0);
                           }};
const Operation fused{
    "fma", 0, UnitRule::none, [](std::span<const Number> n) -> Number {
        return std::fma(std::get<float>(n[0]), std::get<float>(n[1]), std::get<float>(n[2]));
    }};

// ---- weights

struct Weights {
    Real first; ///< λ1 or b1
    Real second;
};

Weights add_weights_of_edges(ValueList& list, const StepContext& context) {
    const Whole e20 = add_edge_value(list, context, 2);
    const Whole e01 = add_edge_value(list, context, 0);
    const Real inverse =
        context.value(StepKind::setup, "1/2A", context.piece().setup->inv_doubled_area, -2);
    const Real lambda1 = list.add("λ1", to_float(e20) * inverse);
    const Real lambda2 = list.add("λ2", to_float(e01) * inverse);
    list.add("λ0", (Real{1.0F} - lambda1) - lambda2);
    return {lambda1, lambda2};
}

/// Along a line: the pixel's center projected onto it.
Weights add_weights_of_line(ValueList& list, const StepContext& context) {
    const auto& window = context.piece().window;
    const auto fixed = [&](unsigned corner, unsigned axis) {
        const FixedPosition& p = window[corner].fixed;
        return to_double(context.value(
            StepKind::viewport,
            fmt::format("v{}.fixed.{}", corner, axis_names[axis]),
            std::int64_t{axis == 0 ? p.x : p.y},
            1
        ));
    };
    const bool point = context.step.primitive == scene::PrimitiveKind::point;
    const Wide dx = fixed(point ? 0 : 1, 0) - fixed(0, 0);
    const Wide dy = fixed(point ? 0 : 1, 1) - fixed(0, 1);
    const Wide length = list.add("|ab|²", dx * dx + dy * dy);
    Real t{0.0F};
    if (length.value() != 0.0) {
        const PixelPos p = context.step.pixel;
        const Wide x = to_double(pixel_coordinate("x", p.x)) - fixed(0, 0);
        const Wide y = to_double(pixel_coordinate("y", p.y)) - fixed(0, 1);
        t = to_float(call<double>(within_0_1, (x * dx + y * dy) / length));
    }
    const Real lambda1 = list.add("λ1", t);
    list.add("λ0", Real{1.0F} - lambda1);
    return {lambda1, list.add("λ2", Real{0.0F})};
}

Real of_corner(const StepContext& context, StepKind kind, unsigned corner, const char* name) {
    const geometry::WindowVertex& v = context.piece().window[corner];
    // The second end of a line stands for the third vertex, too; a point's one for all
    const unsigned named = context.step.primitive == scene::PrimitiveKind::triangle ? corner
                           : context.step.primitive == scene::PrimitiveKind::line
                               ? std::min(corner, 1U)
                               : 0;
    return context.value(
        kind,
        fmt::format("v{}.{}", named, name),
        kind == StepKind::divide ? v.inv_w : v.window.depth
    );
}

/// From weights in the window to those in space.
Weights add_perspective(ValueList& list, const StepContext& context, const Weights& lambda) {
    Weights b = lambda;
    if (context.call().settings.interpolation == scene::InterpolationKind::perspective) {
        const auto inv_w = [&](unsigned corner) {
            return of_corner(context, StepKind::divide, corner, "inv_w");
        };
        const Real inverse = list.add(
            "1/w", math::interpolate(inv_w(0), inv_w(1), inv_w(2), lambda.first, lambda.second)
        );
        const Real w = list.add("w", call<float>(reciprocal, inverse));
        b.first = (lambda.first * inv_w(1)) * w;
        b.second = (lambda.second * inv_w(2)) * w;
    }
    b.first = list.add("b1", b.first);
    b.second = list.add("b2", b.second);
    list.add("b0", (Real{1.0F} - b.first) - b.second);
    return b;
}

/// Across the eye nothing has a place in the window: the planes give weights and depth.
Weights add_weights_of_planes(ValueList& list, const StepContext& context) {
    const raster::PlaneTest& test = *context.detail.traversal->planes;
    const std::array<TermVertex, 3> corners = corners_of_piece(context);
    const std::array rho_values{test.edges[1], test.edges[2], test.edges[0]};
    const Wide inv_w = context.value(StepKind::plane_test, "1/w", test.inv_w);
    std::vector<Real> lambda;
    std::vector<Real> b;
    Wide z{0.0};
    for (unsigned i = 0; i < 3; ++i) {
        const Wide rho = context.value(StepKind::plane_test, fmt::format("ρ{}", i), rho_values[i]);
        lambda.push_back(
            list.add(fmt::format("λ{}", i), to_float(rho * to_double(corners[i].position[3])))
        );
        b.push_back(list.add(fmt::format("b{}", i), to_float(rho / inv_w)));
        z = z + rho * to_double(corners[i].position[2]);
    }
    const geometry::Viewport& viewport = context.call().viewport;
    const Origin convention{{}, {}, "settings.depth.convention"};
    list.add(
        "depth",
        call<float>(
            fused,
            to_float(list.add("z/w", z)),
            operand("depth scale", viewport.depth_scale, convention),
            operand("depth offset", viewport.depth_offset, convention)
        )
    );
    const bool perspective =
        context.call().settings.interpolation == scene::InterpolationKind::perspective;
    return perspective ? Weights{b[1], b[2]} : Weights{lambda[1], lambda[2]};
}

/// A ray brings the weights in space from where it hit, and the depth with them.
Weights add_weights_of_ray(ValueList& list, const StepContext& context) {
    const raster::Fragment& fragment = context.detail.fragment->fragment;
    const Origin hit{{}, {}, "where the ray hit"};
    const auto given = [&](const std::string& name, float value) {
        return list.add(name, operand(name, value, hit));
    };
    for (unsigned i = 0; i < 3; ++i) {
        given(fmt::format("λ{}", i), fragment.barycentric[i]);
    }
    given("b0", fragment.barycentric_clip[0]);
    const Real b1 = given("b1", fragment.barycentric_clip[1]);
    const Real b2 = given("b2", fragment.barycentric_clip[2]);
    given("depth", fragment.depth);
    return {b1, b2};
}

void add_varyings(ValueList& list, const StepContext& context, const Weights& b) {
    const std::array<TermVertex, 3> corners = corners_of_piece(context);
    const math::VaryingLayout& layout = context.call().vertex.layout;
    for (int i = 0; i < layout.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        list.add(
            varying_name(layout, i),
            math::interpolate(
                corners[0].varyings[k],
                corners[1].varyings[k],
                corners[2].varyings[k],
                b.first,
                b.second
            )
        );
    }
}

// ---- shading

Real varying(const StepContext& context, int index) {
    return context.value(
        StepKind::interpolate,
        varying_name(context.call().vertex.layout, index),
        context.detail.fragment->fragment.varyings[index]
    );
}

Triple varyings_at(const StepContext& context, int first) {
    return {varying(context, first), varying(context, first + 1), varying(context, first + 2)};
}

const Operation repeated_texel{"texel", 0, UnitRule::none, [](std::span<const Number> n) -> Number {
                                   const auto size = static_cast<int>(std::get<std::int64_t>(n[1]));
                                   return std::int64_t{
                                       shading::repeat_texel(std::get<float>(n[0]), size)};
                               }};

/// Color times texel.
std::array<Real, 4> add_surface(ValueList& list, const StepContext& context) {
    std::array<Real, 4> color{
        varying(context, 0), varying(context, 1), varying(context, 2), varying(context, 3)};
    const shading::ShadingInputs& in = context.call().vertex.shading;
    if (in.texture == nullptr) {
        return color;
    }
    const auto size = [](const char* name, int value) {
        return operand(name, std::int64_t{value}, {{}, {}, "the texture"});
    };
    const Whole i = list.add(
        "texel.i",
        call<std::int64_t>(
            repeated_texel, varying(context, in.layout.uv), size("width", in.texture->width)
        )
    );
    const Whole j = list.add(
        "texel.j",
        call<std::int64_t>(
            repeated_texel, varying(context, in.layout.uv + 1), size("height", in.texture->height)
        )
    );
    const glm::vec4& texel =
        in.texture->texel(static_cast<int>(i.value()), static_cast<int>(j.value()));
    for (unsigned k = 0; k < 4; ++k) {
        const Real channel = operand(
            fmt::format("texel.{}", channel_names[k]),
            texel[static_cast<int>(k)],
            {{}, {}, fmt::format("texel ({}, {}) of the texture", i.value(), j.value())}
        );
        color[k] = list.add(fmt::format("surface.{}", channel_names[k]), color[k] * channel);
    }
    return color;
}

} // namespace

void add_interpolation_values(ValueList& list, const StepContext& context) {
    const trace::PieceDetail& piece = context.piece();
    if (piece.planes && !piece.setup) {
        add_varyings(list, context, add_weights_of_planes(list, context));
        return;
    }
    if (context.recording.settings().visibility == scene::Visibility::ray_cast) {
        add_varyings(list, context, add_weights_of_ray(list, context));
        return;
    }
    const Weights lambda =
        piece.line ? add_weights_of_line(list, context) : add_weights_of_edges(list, context);
    const auto depth = [&](unsigned corner) {
        return of_corner(context, StepKind::viewport, corner, "window.depth");
    };
    list.add("depth", math::interpolate(depth(0), depth(1), depth(2), lambda.first, lambda.second));
    add_varyings(list, context, add_perspective(list, context, lambda));
}

void add_shading_values(ValueList& list, const StepContext& context) {
    const shading::ShadingInputs& in = context.call().vertex.shading;
    const std::array<Real, 4> color = add_surface(list, context);
    if (in.shading == scene::Shading::phong) {
        add_lighting(
            list,
            context.call(),
            {varyings_at(context, in.layout.eye_position),
             varyings_at(context, in.layout.normal),
             {color[0], color[1], color[2]}},
            "color."
        );
        list.add("color.a", color[3]);
        return;
    }
    for (unsigned k = 0; k < 4; ++k) {
        list.add(fmt::format("color.{}", channel_names[k]), color[k]);
    }
}

} // namespace hs::explain
