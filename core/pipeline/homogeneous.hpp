// A triangle drawn without clipping: vertices go to the planes through the eye as they are.
//
// Olano and Greer, Triangle Scan Conversion Using 2D Homogeneous Coordinates, 1997.
#pragma once

#include "core/geometry/facing.hpp"
#include "core/pipeline/fault.hpp"
#include "core/pipeline/frame.hpp"
#include "core/pipeline/narration.hpp"
#include "core/raster/homogeneous.hpp"

#include <cmath>

namespace hs::pipeline {

/// A triangle as homogeneous rasterization takes it.
struct HomogeneousTriangle {
    std::array<math::ClipPosition, 3> clip{};
    std::array<geometry::WindowVertex, 3> window{};

    /// Whether every vertex has w > 0 and a place in the window.
    [[nodiscard]] bool in_front_of_eye() const;
};

/// Homogeneous window coordinates: the viewport transform without the divide.
[[nodiscard]] std::array<raster::HomogeneousVertex, 3>
homogeneous_vertices(const DrawCall& call, const HomogeneousTriangle& triangle);

/// Adds the planes that must be tested at pixels: those of near, far and user planes the triangle
/// crosses.
void add_crossed_planes(
    raster::HomogeneousSetup& setup,
    const DrawCall& call,
    const HomogeneousTriangle& triangle,
    geometry::Outcode crossed
);

/// What face and setup made of a triangle.
struct PlanesOrVerdict {
    std::optional<raster::HomogeneousSetup> setup;
    geometry::TriangleVerdict verdict = geometry::TriangleVerdict::drawn;
};

/// In front of the eye a triangle has a place in the window, and its snapped area decides.
template <TraceSink Trace>
PlanesOrVerdict set_up_in_front(
    const DrawCall& call, const HomogeneousTriangle& triangle, const PixelRect& region, Trace& trace
) {
    const auto& [v0, v1, v2] = triangle.window;
    trace.divided(triangle.window);
    trace.mapped(triangle.window);
    const std::int64_t area = geometry::doubled_area(v0.fixed, v1.fixed, v2.fixed);
    const auto verdict = geometry::face_verdict(area, call.settings.front_face, call.settings.cull);
    trace.faced(area, verdict);
    if (verdict != geometry::TriangleVerdict::drawn) {
        return {std::nullopt, verdict};
    }
    const raster::TriangleSetup window =
        set_up_edges(call, {v0.fixed, v1.fixed, v2.fixed}, area, region);
    const std::array<double, 3> w{
        static_cast<double>(triangle.clip[0].w),
        static_cast<double>(triangle.clip[1].w),
        static_cast<double>(triangle.clip[2].w)};
    return {raster::set_up_planes(window, w), verdict};
}

/// Which side is seen, where only the sign of the determinant tells.
[[nodiscard]] inline geometry::TriangleVerdict
face_by_determinant(const DrawCall& call, double determinant) {
    const std::int64_t side = determinant < 0.0 ? 1 : determinant > 0.0 ? -1 : 0;
    const bool finite = std::isfinite(determinant);
    return geometry::face_verdict(finite ? side : 0, call.settings.front_face, call.settings.cull);
}

/// Across the eye only the determinant tells which side is seen.
template <TraceSink Trace>
PlanesOrVerdict set_up_across_eye(
    const DrawCall& call, const HomogeneousTriangle& triangle, const PixelRect& region, Trace& trace
) {
    const auto vertices = homogeneous_vertices(call, triangle);
    const double determinant = raster::determinant(vertices);
    const auto verdict = face_by_determinant(call, determinant);
    trace.oriented(determinant, verdict);
    if (verdict != geometry::TriangleVerdict::drawn) {
        return {std::nullopt, verdict};
    }
    return {raster::set_up_planes(vertices, region), verdict};
}

/// `draw(fragment)` for every covered pixel of `region`. `interpolants` are those of the vertices
/// as they are.
template <TraceSink Trace, typename Draw>
// NOLINTNEXTLINE(readability-function-size): a stage is handed all it needs, and looks up nothing
geometry::TriangleVerdict draw_homogeneous(
    const DrawCall& call,
    const HomogeneousTriangle& triangle,
    const raster::Interpolants& interpolants,
    geometry::Outcode crossed,
    raster::UnitRange units,
    const PixelRect& region,
    Trace& trace,
    Draw&& draw
) {
    // Face and set up the planes through the eye
    PlanesOrVerdict planes = triangle.in_front_of_eye()
                                 ? set_up_in_front(call, triangle, region, trace)
                                 : set_up_across_eye(call, triangle, region, trace);
    if (!planes.setup) {
        return planes.verdict;
    }
    raster::HomogeneousSetup& setup = *planes.setup;
    add_crossed_planes(setup, call, triangle, crossed);
    trace.planes_set_up(setup);

    // Traverse: in front of the eye fragments are those of every other traversal
    const raster::HomogeneousInterpolants across{
        .varyings = interpolants,
        .z = {triangle.clip[0].z, triangle.clip[1].z, triangle.clip[2].z},
        .w = {triangle.clip[0].w, triangle.clip[1].w, triangle.clip[2].w},
        .depth_scale = call.viewport.depth_scale,
        .depth_offset = call.viewport.depth_offset};
    bool any = false;
    raster::visit_planes(setup, units, trace, [&](PixelPos pixel, const raster::PlaneTest& test) {
        any = true;
        draw(
            setup.window ? raster::interpolate(
                               interpolants, *setup.window, pixel, setup.window->evaluate(pixel)
                           )
                         : raster::interpolate_planes(across, pixel, test)
        );
    });
    return any ? geometry::TriangleVerdict::drawn : geometry::TriangleVerdict::no_sample_covered;
}

} // namespace hs::pipeline
