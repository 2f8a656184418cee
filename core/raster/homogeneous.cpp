#include "core/raster/homogeneous.hpp"

#include "core/base/check.hpp"
#include "core/math/interpolate.hpp"

#include <cmath>

namespace hs::raster {
namespace {

/// The plane through the eye and two vertices, u × v. Turning the edge around negates it exactly.
PixelFunction plane_through(const HomogeneousVertex& u, const HomogeneousVertex& v) {
    return {u.y * v.w - u.w * v.y, u.w * v.x - u.x * v.w, u.x * v.y - u.y * v.x};
}

PixelFunction scaled(const PixelFunction& f, double by) {
    return {f.a * by, f.b * by, f.c * by};
}

/// An edge function as a function of whole pixels.
PixelFunction as_pixel_function(const EdgeFunction& e) {
    return {
        static_cast<double>(e.a * subpixel_scale),
        static_cast<double>(e.b * subpixel_scale),
        static_cast<double>(e.c)};
}

} // namespace

double determinant(const std::array<HomogeneousVertex, 3>& v) {
    const PixelFunction plane = plane_through(v[1], v[2]);
    return (plane.a * v[0].x + plane.b * v[0].y) + plane.c * v[0].w;
}

HomogeneousSetup set_up_planes(const std::array<HomogeneousVertex, 3>& v, const PixelRect& region) {
    const double det = determinant(v);
    HS_DCHECK(std::isfinite(det) && det != 0.0, "a degenerate triangle has no planes");
    HomogeneousSetup setup;
    setup.region = region;
    for (unsigned k = 0; k < 3; ++k) {
        const HomogeneousVertex& from = v[k];
        const HomogeneousVertex& to = v[(k + 1) % 3];
        EyePlane& plane = setup.edges[k];
        plane.rho = scaled(plane_through(from, to), 1.0 / det);
        if (from.snapped && to.snapped) {
            plane.snapped = edge_through(*from.snapped, *to.snapped, det > 0.0);
        }
    }
    return setup;
}

HomogeneousSetup set_up_planes(const TriangleSetup& window, const std::array<double, 3>& w) {
    HomogeneousSetup setup;
    setup.region = window.bounds;
    setup.window = window;
    for (unsigned k = 0; k < 3; ++k) {
        EyePlane& plane = setup.edges[k];
        plane.snapped = window.edges[k];
        plane.rho = scaled(
            as_pixel_function(window.edges[k]),
            1.0 / (static_cast<double>(window.doubled_area) * w[(k + 2) % 3])
        );
    }
    return setup;
}

void add_clip(HomogeneousSetup& setup, int plane, const std::array<double, 3>& distances) {
    PixelClip& clip = setup.clips[static_cast<unsigned>(setup.clip_count++)];
    clip.plane = plane;
    for (unsigned k = 0; k < 3; ++k) {
        const PixelFunction part = scaled(setup.edges[k].rho, distances[(k + 2) % 3]);
        clip.distance.a += part.a;
        clip.distance.b += part.b;
        clip.distance.c += part.c;
    }
}

PlaneTest test_planes(const HomogeneousSetup& setup, PixelPos pixel) {
    PlaneTest test;
    test.inside = true;
    for (unsigned k = 0; k < 3; ++k) {
        test.edges[k] = setup.edges[k].rho(pixel);
        test.inside = test.inside && setup.edges[k].covers(pixel);
    }
    test.inv_w = (test.edges[0] + test.edges[1]) + test.edges[2];
    test.inside = test.inside && test.inv_w > 0.0;
    for (unsigned i = 0; i < static_cast<unsigned>(setup.clip_count); ++i) {
        test.clips[i] = setup.clips[i].distance(pixel);
        test.inside = test.inside && test.clips[i] >= 0.0;
    }
    return test;
}

Fragment
interpolate_planes(const HomogeneousInterpolants& in, PixelPos pixel, const PlaneTest& test) {
    Fragment f;
    f.pixel = pixel;
    const std::array rho{test.edges[1], test.edges[2], test.edges[0]}; // of vertices 0, 1, 2

    // Weights: ρ_i over 1/w in space, ρ_i · w_i in the window
    for (unsigned i = 0; i < 3; ++i) {
        f.barycentric[i] = static_cast<float>(rho[i] * static_cast<double>(in.w[i]));
        f.barycentric_clip[i] = static_cast<float>(rho[i] / test.inv_w);
    }

    // z / w is linear in the window
    double z = 0.0;
    for (unsigned i = 0; i < 3; ++i) {
        z += rho[i] * static_cast<double>(in.z[i]);
    }
    f.depth = std::fma(static_cast<float>(z), in.depth_scale, in.depth_offset);

    // Interpolate what the shading uses
    const auto& weights = in.varyings.perspective ? f.barycentric_clip : f.barycentric;
    for (int i = 0; i < in.varyings.varying_count; ++i) {
        f.varyings[i] = math::interpolate(
            in.varyings.varyings0[i],
            in.varyings.varyings1[i],
            in.varyings.varyings2[i],
            weights[1],
            weights[2]
        );
    }
    return f;
}

} // namespace hs::raster
