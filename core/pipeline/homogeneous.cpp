#include "core/pipeline/homogeneous.hpp"

#include <algorithm>

namespace hs::pipeline {
namespace {

bool has_place(const math::ClipPosition& clip, const geometry::WindowVertex& window) {
    return clip.w > 0.0F && window.status == geometry::WindowStatus::placed;
}

/// The sides are where the region ends.
bool tested_at_pixels(geometry::ClipPlane plane) {
    return plane <= geometry::ClipPlane::far || plane >= geometry::ClipPlane::user0;
}

} // namespace

bool HomogeneousTriangle::in_front_of_eye() const {
    return has_place(clip[0], window[0]) && has_place(clip[1], window[1]) &&
           has_place(clip[2], window[2]);
}

std::array<raster::HomogeneousVertex, 3>
homogeneous_vertices(const DrawCall& call, const HomogeneousTriangle& triangle) {
    constexpr double to_center = 0.5; // pixel (0, 0) has its center there
    std::array<raster::HomogeneousVertex, 3> vertices;
    for (unsigned k = 0; k < 3; ++k) {
        const math::ClipPosition& clip = triangle.clip[k];
        const auto w = static_cast<double>(clip.w);
        const auto from_center = [w](float center, float half, float coordinate) {
            return (static_cast<double>(center) - to_center) * w +
                   static_cast<double>(half) * static_cast<double>(coordinate);
        };
        vertices[k].x = from_center(call.viewport.center_x, call.viewport.half_width, clip.x);
        vertices[k].y = from_center(call.viewport.center_y, call.viewport.half_height, -clip.y);
        vertices[k].w = w;
        if (has_place(clip, triangle.window[k])) {
            vertices[k].snapped = triangle.window[k].fixed;
        }
    }
    return vertices;
}

void add_crossed_planes(
    raster::HomogeneousSetup& setup,
    const DrawCall& call,
    const HomogeneousTriangle& triangle,
    geometry::Outcode crossed
) {
    for (int k = 0; k < call.volume.count; ++k) {
        const bool outside = (crossed >> static_cast<unsigned>(k) & 1U) != 0;
        if (!outside || !tested_at_pixels(static_cast<geometry::ClipPlane>(k))) {
            continue;
        }
        std::array<double, 3> distances{};
        for (unsigned corner = 0; corner < 3; ++corner) {
            distances[corner] = static_cast<double>(math::signed_distance(
                call.volume.planes[static_cast<unsigned>(k)], math::to_vec4(triangle.clip[corner])
            ));
        }
        raster::add_clip(setup, k, distances);
    }
}

} // namespace hs::pipeline
