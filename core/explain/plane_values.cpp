// The values of homogeneous rasterization: planes through the eye, in doubles.
#include "core/explain/value_list.hpp"

#include <fmt/format.h>

#include <cmath>

namespace hs::explain {
namespace {

using trace::StepKind;

/// A vertex in homogeneous window coordinates.
struct TermPoint {
    Wide x, y, w;
};

/// a·x + b·y + c over pixel centers.
struct TermFunction {
    Wide a, b, c;
};

/// Pixel (0, 0) is centered at 0; across the eye, where only the facing step has them.
TermPoint add_point(ValueList& list, const StepContext& context, unsigned corner) {
    const geometry::Viewport& viewport = context.call().viewport;
    const TermVertex v = corners_of_piece(context)[corner];
    const Wide w = to_double(v.position[3]);
    const auto number = [](const char* symbol, float value) {
        return to_double(operand(symbol, value, {{}, {}, "settings.viewport"}));
    };
    const auto from_center = [&](const Wide& center, const Wide& half, const Wide& coordinate) {
        return (center - Wide{0.5}) * w + half * coordinate;
    };
    const auto name = [corner](const char* axis) { return fmt::format("v{}.{}", corner, axis); };
    return {
        list.add(
            name("X"),
            from_center(
                number("center.x", viewport.center_x),
                number("W/2", viewport.half_width),
                to_double(v.position[0])
            )
        ),
        list.add(
            name("Y"),
            from_center(
                number("center.y", viewport.center_y),
                number("H/2", viewport.half_height),
                to_double(-v.position[1])
            )
        ),
        list.add(name("W"), w)};
}

/// The same, as a later step refers to them.
TermPoint point_of_facing(const StepContext& context, unsigned corner) {
    ValueList facing(context.path(StepKind::facing));
    return add_point(facing, context, corner);
}

TermFunction plane_through(const TermPoint& u, const TermPoint& v) {
    return {u.y * v.w - u.w * v.y, u.w * v.x - u.x * v.w, u.x * v.y - u.y * v.x};
}

TermFunction scaled(const TermFunction& f, const Wide& by) {
    return {f.a * by, f.b * by, f.c * by};
}

TermFunction add_function(ValueList& list, const std::string& name, const TermFunction& f) {
    return {list.add(name + ".a", f.a), list.add(name + ".b", f.b), list.add(name + ".c", f.c)};
}

std::string plane_name(unsigned edge) {
    return fmt::format("ρ{}", (edge + 2) % 3); // of the vertex opposite
}

/// In front of the eye: the edge function over twice the area and the opposite vertex's w.
TermFunction
plane_in_front(const StepContext& context, unsigned k, const std::array<TermVertex, 3>& corners) {
    const raster::TriangleSetup& window = *context.piece().setup;
    const raster::EdgeFunction& e = window.edges[k];
    const auto coefficient = [&](char which, std::int64_t value) {
        const Whole raw = context.value(
            StepKind::setup,
            fmt::format("{}.{}", edge_names[k], which),
            value,
            which == 'c' ? 2 : 1
        );
        const Whole one_pixel =
            operand("1 px", std::int64_t{subpixel_scale}, {{}, {}, "from pixel to pixel"}, 1);
        return to_double(which == 'c' ? raw : raw * one_pixel);
    };
    const Whole doubled = context.value(StepKind::setup, "2A", window.doubled_area, 2);
    const Wide by =
        Wide{1.0} / (to_double(doubled) * to_double(corners[(k + 2) % 3].position[3]));
    return scaled({coefficient('a', e.a), coefficient('b', e.b), coefficient('c', e.c)}, by);
}

TermFunction plane_across(const StepContext& context, unsigned k) {
    const Wide determinant =
        context.value(StepKind::facing, "determinant", *context.piece().determinant);
    return scaled(
        plane_through(point_of_facing(context, k), point_of_facing(context, (k + 1) % 3)),
        Wide{1.0} / determinant
    );
}

/// Its distance over w, from the vertices' distances: those that the outcodes asked.
void add_clip_function(
    ValueList& list,
    const StepContext& context,
    geometry::ClipPlane plane,
    const std::vector<TermFunction>& rho
) {
    const std::string name{name_of(plane)};
    const auto& clip = context.call().volume.planes[static_cast<std::size_t>(plane)];
    TermFunction sum{0.0, 0.0, 0.0};
    for (unsigned k = 0; k < 3; ++k) {
        const unsigned corner = (k + 2) % 3;
        const Wide distance = to_double(context.value(
            StepKind::outcodes,
            fmt::format("v{}.{}", corner, name),
            math::signed_distance(
                clip, math::to_vec4(context.detail.triangle->corners[corner].work.clip)
            )
        ));
        const TermFunction part = scaled(rho[k], distance);
        sum = {sum.a + part.a, sum.b + part.b, sum.c + part.c};
    }
    add_function(list, name, sum);
}

Wide at_pixel(const StepContext& context, const std::string& name, const raster::PixelFunction& f) {
    const auto coefficient = [&](const char* which, double value) {
        return context.value(StepKind::setup, fmt::format("{}.{}", name, which), value);
    };
    const auto coordinate = [](const char* axis, int value) {
        return operand(axis, static_cast<double>(value), {{}, {}, "the pixel asked"});
    };
    const PixelPos p = context.step.pixel;
    return (coefficient("a", f.a) * coordinate("x", p.x) +
            coefficient("b", f.b) * coordinate("y", p.y)) +
           coefficient("c", f.c);
}

} // namespace

void add_plane_facing_values(ValueList& list, const StepContext& context) {
    const TermPoint v0 = add_point(list, context, 0);
    const TermPoint v1 = add_point(list, context, 1);
    const TermPoint v2 = add_point(list, context, 2);
    const TermFunction plane = plane_through(v1, v2);
    list.add("determinant", (plane.a * v0.x + plane.b * v0.y) + plane.c * v0.w);
}

void add_plane_setup_values(ValueList& list, const StepContext& context) {
    const raster::HomogeneousSetup& setup = *context.piece().planes;
    const std::array<TermVertex, 3> corners = corners_of_piece(context);
    std::vector<TermFunction> rho;
    for (unsigned k = 0; k < 3; ++k) {
        rho.push_back(add_function(
            list,
            plane_name(k),
            setup.window ? plane_in_front(context, k, corners) : plane_across(context, k)
        ));
    }
    for (unsigned i = 0; i < static_cast<unsigned>(setup.clip_count); ++i) {
        add_clip_function(list, context, static_cast<geometry::ClipPlane>(setup.clips[i].plane), rho);
    }
}

void add_plane_test_values(ValueList& list, const StepContext& context) {
    const raster::HomogeneousSetup& setup = *context.piece().planes;
    std::vector<Wide> rho;
    for (unsigned k = 0; k < 3; ++k) {
        rho.push_back(
            list.add(plane_name(k), at_pixel(context, plane_name(k), setup.edges[k].rho))
        );
    }
    list.add("1/w", (rho[0] + rho[1]) + rho[2]);
    for (unsigned i = 0; i < static_cast<unsigned>(setup.clip_count); ++i) {
        const std::string name{name_of(static_cast<geometry::ClipPlane>(setup.clips[i].plane))};
        list.add(name, at_pixel(context, name, setup.clips[i].distance));
    }
    if (setup.window) {
        for (unsigned k = 0; k < 3; ++k) {
            list.add(edge_names[k], edge_term(context, k, context.step.pixel));
        }
    }
}

} // namespace hs::explain
