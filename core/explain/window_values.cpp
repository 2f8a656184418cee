// The values of divide, viewport, facing and setup.
#include "core/explain/value_list.hpp"

#include <fmt/format.h>

#include <cmath>

namespace hs::explain {
namespace {

using trace::StepKind;

const Operation reciprocal{"1 / ", 4, UnitRule::none, [](std::span<const Number> n) -> Number {
                               return math::reciprocal(std::get<float>(n[0]));
                           }};
const Operation fused{"fma", 0, UnitRule::none, [](std::span<const Number> n) -> Number {
                          return std::fma(
                              std::get<float>(n[0]), std::get<float>(n[1]), std::get<float>(n[2])
                          );
                      }};

template <geometry::Snapping snapping>
Number snapped(std::span<const Number> n) {
    return std::int64_t{geometry::snap_by(snapping, std::get<float>(n[0]))};
}
const Operation snap_half_even{
    "snap", 0, UnitRule::subpixels, snapped<geometry::Snapping::half_even>};
const Operation snap_half_up{
    "snap half up", 0, UnitRule::subpixels, snapped<geometry::Snapping::half_up>};
const Operation snap_down{"snap down", 0, UnitRule::subpixels, snapped<geometry::Snapping::floor>};

const Operation& snap_operation(geometry::Snapping snapping) {
    return snapping == geometry::Snapping::half_even ? snap_half_even
           : snapping == geometry::Snapping::half_up ? snap_half_up
                                                     : snap_down;
}

/// Of a piece: a point has one vertex, a line two.
unsigned corner_count(const trace::Step& step) {
    return step.primitive == scene::PrimitiveKind::triangle ? 3
           : step.primitive == scene::PrimitiveKind::line   ? 2
                                                            : 1;
}

std::string of_vertex(unsigned corner, std::string_view name) {
    return fmt::format("v{}.{}", corner, name);
}

Real viewport_number(const char* symbol, float value) {
    return operand(symbol, value, {{}, {}, "settings.viewport"});
}

/// A snapped coordinate, in 1/256 pixel from the center of pixel 0.
Whole fixed_term(const StepContext& context, unsigned corner, unsigned axis) {
    const FixedPosition& fixed = context.piece().window[corner].fixed;
    return context.value(
        StepKind::viewport,
        fmt::format("v{}.fixed.{}", corner, axis_names[axis]),
        std::int64_t{axis == 0 ? fixed.x : fixed.y},
        1
    );
}

void add_edge_setup(ValueList& list, const StepContext& context, unsigned k) {
    const bool negate = context.piece().signed_doubled_area < 0;
    const std::string name = edge_names[k];
    const unsigned next = (k + 1) % 3;
    const Whole from_x = fixed_term(context, k, 0);
    const Whole from_y = fixed_term(context, k, 1);
    const Whole dx = fixed_term(context, next, 0) - from_x;
    const Whole dy = fixed_term(context, next, 1) - from_y;
    const Whole a = list.add(name + ".a", negate ? -dy : dy);
    const Whole b = list.add(name + ".b", negate ? dx : -dx);
    Whole c = -(a * from_x + b * from_y);
    if (context.call().settings.fault == scene::Fault::increment_before_test) {
        c = c + a * operand("1 px", std::int64_t{subpixel_scale}, {{}, {}, "settings.fault"}, 1);
    }
    list.add(name + ".c", c);
}

} // namespace

void add_divide_values(ValueList& list, const StepContext& context) {
    const std::array<TermVertex, 3> corners = corners_of_piece(context);
    const bool divides = context.call().viewport.divides;
    for (unsigned corner = 0; corner < corner_count(context.step); ++corner) {
        const TermVertex& v = corners[corner];
        const Real inv_w = list.add(
            of_vertex(corner, "inv_w"),
            divides ? call<float>(reciprocal, v.position[3]) : Real{1.0F}
        );
        if (!std::isfinite(inv_w.value())) {
            continue; // no place in the window
        }
        for (unsigned k = 0; k < 3; ++k) {
            list.add(
                of_vertex(corner, fmt::format("ndc.{}", axis_names[k])),
                geometry::divide(v.position[k], inv_w)
            );
        }
    }
}

void add_viewport_values(ValueList& list, const StepContext& context) {
    const geometry::Viewport& viewport = context.call().viewport;
    for (unsigned corner = 0; corner < corner_count(context.step); ++corner) {
        const geometry::WindowVertex& v = context.piece().window[corner];
        const auto ndc = [&](const char* axis, float value) {
            return context.value(
                StepKind::divide, of_vertex(corner, fmt::format("ndc.{}", axis)), value
            );
        };
        const Real x = list.add(
            of_vertex(corner, "window.x"),
            call<float>(
                fused,
                ndc("x", v.ndc.x),
                viewport_number("W/2", viewport.half_width),
                viewport_number("center.x", viewport.center_x)
            )
        );
        const Real y = list.add(
            of_vertex(corner, "window.y"),
            call<float>(
                fused,
                -ndc("y", v.ndc.y),
                viewport_number("H/2", viewport.half_height),
                viewport_number("center.y", viewport.center_y)
            )
        );
        const Origin convention{{}, {}, "settings.depth.convention"};
        list.add(
            of_vertex(corner, "window.depth"),
            call<float>(
                fused,
                ndc("z", v.ndc.z),
                operand("depth scale", viewport.depth_scale, convention),
                operand("depth offset", viewport.depth_offset, convention)
            )
        );
        if (v.status == geometry::WindowStatus::placed) {
            const Operation& snap = snap_operation(viewport.snapping);
            list.add(of_vertex(corner, "fixed.x"), call<std::int64_t>(snap, x));
            list.add(of_vertex(corner, "fixed.y"), call<std::int64_t>(snap, y));
        }
    }
}

void add_facing_values(ValueList& list, const StepContext& context) {
    if (context.piece().determinant) {
        add_plane_facing_values(list, context);
        return;
    }
    const auto edge = [&](unsigned to, unsigned axis) {
        return fixed_term(context, to, axis) - fixed_term(context, 0, axis);
    };
    list.add("signed doubled area", edge(2, 0) * edge(1, 1) - edge(2, 1) * edge(1, 0));
}

void add_setup_values(ValueList& list, const StepContext& context) {
    const trace::PieceDetail& piece = context.piece();
    if (piece.line) {
        add_line_setup_values(list, context);
        return;
    }
    if (piece.setup) {
        for (unsigned k = 0; k < 3; ++k) {
            add_edge_setup(list, context, k);
        }
        const Whole area =
            context.value(StepKind::facing, "signed doubled area", piece.signed_doubled_area, 2);
        const Whole doubled = list.add("2A", piece.signed_doubled_area < 0 ? -area : area);
        list.add("1/2A", Real{1.0F} / to_float(doubled));
    }
    if (piece.planes) {
        add_plane_setup_values(list, context);
    }
}

} // namespace hs::explain
