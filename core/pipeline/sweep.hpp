// What rows of the image are made of when they show the nearest of all triangles at once: by
// scanlines in the window, or by rays in the world.
//
// Scanlines see each piece of a triangle as it would be rasterized: clipped, divided, snapped, with
// depth linear between its snapped corners. So they ask what a z-buffer asks, in another order.
#pragma once

#include "core/pipeline/draw.hpp"
#include "core/visibility/ray_cast.hpp"
#include "core/visibility/scanline.hpp"
#include "core/visibility/scanline_z.hpp"

#include <memory>
#include <vector>

namespace hs::pipeline {

struct Sweep {
    std::vector<PieceName> polygons; ///< by the numbers that events use
    // Scanlines
    std::vector<PieceSetup> setups; ///< one per polygon
    std::shared_ptr<const visibility::ScanScene> scan;
    // Rays
    std::vector<visibility::RayTriangle> triangles; ///< one per polygon
    glm::dmat4 clip_to_world{1.0};

    [[nodiscard]] const PieceName& polygon(std::int32_t i) const {
        return polygons[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] std::size_t bytes() const;
};

/// Listens to every algorithm that sweeps the image.
template <typename Sink>
concept AnySweepSink = visibility::SweepSink<Sink, visibility::ScanState> &&
    visibility::SweepSink<Sink, visibility::LineBuffer> &&
    visibility::SweepSink<Sink, visibility::RayCast>;

/// Precondition: the vertex stage has run, and `refuse_order` has no complaint about lines or
/// vertices.
std::shared_ptr<const Sweep> make_sweep(const Frame& frame);

/// The rows that may show triangles: all calls share one viewport.
[[nodiscard]] inline PixelRect swept_region(const Frame& frame) {
    return frame.settings().clip_enabled ? frame.settings().viewport() : frame.settings().image();
}

/// From the near plane to the far plane, through a pixel's center.
[[nodiscard]] visibility::Ray pixel_ray(const Frame& frame, const Sweep& sweep, PixelPos pixel);

/// What a ray of this frame and a fragment of a rasterized triangle have in common: weights and
/// depth, here from the point that was hit. Precondition: the ray hit the triangle.
[[nodiscard]] raster::Fragment hit_fragment(
    const DrawCall& call, std::uint32_t triangle, PixelPos pixel, const glm::dvec3& weights
);

/// Whether a triangle shows the side that is culled, or is edge-on, by the sign of its determinant:
/// it may reach behind the eye.
struct SeenSide {
    double determinant = 0.0;
    geometry::TriangleVerdict verdict = geometry::TriangleVerdict::drawn;
};
[[nodiscard]] SeenSide seen_side(const DrawCall& call, std::uint32_t triangle);

/// Decisions of a whole frame: exact for rays, for scanlines from some of the rows.
[[nodiscard]] double estimate_sweep(const Frame& frame);

} // namespace hs::pipeline
