// Homogeneous rasterization: every edge is a plane through the eye, so a triangle needs neither
// clipping nor, where a vertex lies behind the eye, a place for it in the window.
//
// Olano and Greer, Triangle Scan Conversion Using 2D Homogeneous Coordinates, 1997. With rows
// (x, y, w) of the vertices in homogeneous window coordinates, the inverse of their matrix turns a
// pixel (x, y, 1) into ρ_i = b_i / w: three numbers, none negative inside, whose sum is 1/w.
// Turning all signs of the vertices around leaves the three cross products alone but not the
// determinant they are divided by: a triangle behind the eye gets 1/w < 0 and draws nothing.
//
// Differs: an edge between two vertices that have a place in the window runs through their snapped
// places, in exact integers. So a triangle in front of the eye covers what the other traversals
// say, and neighbors agree along their edge whatever their third vertices do.
#pragma once

#include "core/raster/interpolation.hpp"
#include "core/raster/traversal.hpp"

#include <array>
#include <optional>

namespace hs::raster {

/// A vertex before the divide: homogeneous window coordinates in pixels, pixel (0, 0) centered at
/// 0.
struct HomogeneousVertex {
    double x = 0.0;
    double y = 0.0;
    double w = 0.0;
    std::optional<FixedPosition> snapped; ///< x/w, y/w, if w > 0 and they are within the snap limit
};

/// a·x + b·y + c over pixel centers.
struct PixelFunction {
    double a = 0.0;
    double b = 0.0;
    double c = 0.0;
    [[nodiscard]] double operator()(PixelPos p) const {
        return (a * static_cast<double>(p.x) + b * static_cast<double>(p.y)) + c;
    }
};

/// The plane through the eye and an edge.
struct EyePlane {
    PixelFunction rho;                   ///< of the vertex opposite, positive inside
    std::optional<EdgeFunction> snapped; ///< decides the side where there is one, exactly

    /// Ties by the top-left rule, as edge functions have it.
    [[nodiscard]] bool covers(PixelPos p) const {
        if (snapped) {
            const std::int64_t e = (*snapped)(p);
            return e > 0 || (e == 0 && snapped->owns_ties());
        }
        const double value = rho(p);
        return value > 0.0 || (value == 0.0 && (rho.a > 0.0 || (rho.a == 0.0 && rho.b > 0.0)));
    }
};

/// A clip plane still to be tested at pixels: its distance over w. Near, far and user planes;
/// the sides are the region's.
struct PixelClip {
    int plane = 0; ///< as numbered by the clip volume
    PixelFunction distance;
};

struct HomogeneousSetup {
    std::array<EyePlane, 3> edges{}; ///< E01, E12, E20: ρ2, ρ0, ρ1
    std::array<PixelClip, 4> clips{};
    int clip_count = 0;
    PixelRect region;                    ///< pixels to ask
    std::optional<TriangleSetup> window; ///< if all three vertices have a place in the window
};

/// Of the three vertices: > 0 for triangles that are clockwise as seen (y is down).
[[nodiscard]] double determinant(const std::array<HomogeneousVertex, 3>& v);

/// Precondition: the determinant is finite and not 0.
[[nodiscard]] HomogeneousSetup
set_up_planes(const std::array<HomogeneousVertex, 3>& v, const PixelRect& region);

/// A triangle in front of the eye: the planes of its edge functions. `w` are its vertices'.
[[nodiscard]] HomogeneousSetup
set_up_planes(const TriangleSetup& window, const std::array<double, 3>& w);

/// Adds a clip plane by its signed distances at the vertices.
void add_clip(HomogeneousSetup& setup, int plane, const std::array<double, 3>& distances);

[[nodiscard]] PlaneTest test_planes(const HomogeneousSetup& setup, PixelPos pixel);

/// What is interpolated where vertices have no place in the window.
struct HomogeneousInterpolants {
    Interpolants varyings; ///< of which the varyings are used
    std::array<float, 3> z{};
    std::array<float, 3> w{};
    float depth_scale = 0.5F; ///< of the viewport
    float depth_offset = 0.5F;
};

[[nodiscard]] Fragment
interpolate_planes(const HomogeneousInterpolants& in, PixelPos pixel, const PlaneTest& test);

/// Asks every pixel of the region, row by row; unit k is its k-th row. `emit(pixel, plane test)`.
template <TraversalTrace Trace, typename Emit>
void visit_planes(const HomogeneousSetup& setup, UnitRange units, Trace& trace, Emit&& emit) {
    if (setup.region.empty()) {
        return;
    }
    const auto clips = static_cast<std::uint64_t>(setup.clip_count);
    const int last = std::min(units.last, setup.region.height());
    for (int unit = units.first; unit < last; ++unit) {
        trace.unit(unit);
        for (int x = setup.region.x0; x < setup.region.x1; ++x) {
            const PixelPos pixel{x, setup.region.y0 + unit};
            const PlaneTest test = test_planes(setup, pixel);
            trace.cost({.pixels = 1, .evaluations = 3 + clips, .sums = 2});
            trace.planes_tested(pixel, test);
            if (test.inside) {
                emit(pixel, test);
            }
        }
    }
}

/// The bounding box of a triangle in front of the eye.
template <TraversalTrace Trace, typename Emit>
void traverse_homogeneous(
    const TriangleSetup& setup,
    const PixelRect& /*image*/,
    UnitRange units,
    Trace& trace,
    Emit&& emit
) {
    const HomogeneousSetup planes = set_up_planes(setup, {1.0, 1.0, 1.0});
    visit_planes(planes, units, trace, [&](PixelPos pixel, const PlaneTest&) {
        emit(pixel, setup.evaluate(pixel));
    });
}

} // namespace hs::raster
