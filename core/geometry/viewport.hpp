// Perspective divide, viewport transform and snap: from clip space to pixels.
//
// OpenGL 4.6, section 13.8 (Coordinate Transformations). Differs: y points down in window
// coordinates. One reciprocal, one product, one fused multiply-add per coordinate, all in float32:
// this is what llvmpipe executes, and the only order of rounding that agrees with it on every
// pixel.
#pragma once

#include "core/base/fixed.hpp"
#include "core/base/pixel.hpp"
#include "core/math/reciprocal.hpp"
#include "core/math/space.hpp"
#include "core/scene/settings.hpp"

#include <cmath>
#include <cstdint>

namespace hs::geometry {

/// How a window coordinate becomes a multiple of 1/256 pixel. Only the first is right; the others
/// are there to be seen.
enum class Snapping : std::uint8_t {
    half_even,
    half_up,
    floor
};

/// Where NDC lands: x right, y down, in pixels; and how z becomes depth.
struct Viewport {
    float half_width = 0.0F;  ///< W / 2
    float half_height = 0.0F; ///< H / 2
    float center_x = 0.0F;    ///< x of the viewport + W / 2
    float center_y = 0.0F;
    float depth_scale = 0.5F; ///< depth = z_ndc · scale + offset: ½, ½ in OpenGL, 1, 0 elsewhere
    float depth_offset = 0.5F;
    Snapping snapping = Snapping::half_even;
    bool divides = true; ///< by w; false only as a fault
};

[[nodiscard]] inline Viewport
make_viewport(const PixelRect& rect, scene::DepthConvention convention) {
    const float half_width = static_cast<float>(rect.width()) * 0.5F;
    const float half_height = static_cast<float>(rect.height()) * 0.5F;
    const bool opengl = convention == scene::DepthConvention::opengl;
    return {
        .half_width = half_width,
        .half_height = half_height,
        .center_x = static_cast<float>(rect.x0) + half_width,
        .center_y = static_cast<float>(rect.y0) + half_height,
        .depth_scale = opengl ? 0.5F : 1.0F,
        .depth_offset = opengl ? 0.5F : 0.0F,
    };
}

/// Whether a vertex has a place in the window.
enum class WindowStatus : std::uint8_t {
    placed,  ///< it has
    at_eye,  ///< w = 0 or not finite: no perspective divide
    too_far, ///< beyond the snap limit: edge functions could overflow
};

/// A vertex after the divide, kept in every later space.
struct WindowVertex {
    math::NdcPosition ndc;
    math::WindowPosition window;
    float inv_w = 0.0F; ///< 1 / w_clip, kept for perspective-correct interpolation
    FixedPosition fixed;
    WindowStatus status = WindowStatus::at_eye;
};

/// x_ndc = x · (1/w). Templated on the scalar, like every formula people are shown.
template <typename T>
[[nodiscard]] T divide(T coordinate, T inv_w) {
    return coordinate * inv_w;
}

/// Center + half extent · NDC, rounded once.
[[nodiscard]] inline float map_to_window(float ndc, float half_extent, float center) {
    return std::fma(ndc, half_extent, center);
}

/// Precondition: |coordinate| < snap_limit.
[[nodiscard]] inline std::int32_t snap_by(Snapping snapping, float coordinate) {
    if (snapping == Snapping::half_even) {
        return snap(coordinate);
    }
    const float fixed = (coordinate - 0.5F) * static_cast<float>(subpixel_scale);
    return static_cast<std::int32_t>(std::floor(snapping == Snapping::floor ? fixed : fixed + 0.5F)
    );
}

[[nodiscard]] inline WindowVertex
to_window(const math::ClipPosition& clip, const Viewport& viewport) {
    WindowVertex v;
    v.inv_w = viewport.divides ? math::reciprocal(clip.w) : 1.0F;
    if (!std::isfinite(v.inv_w)) {
        return v;
    }

    // Divide by w
    v.ndc = {divide(clip.x, v.inv_w), divide(clip.y, v.inv_w), divide(clip.z, v.inv_w)};

    // Map NDC to pixels, y up to y down, and z to depth
    v.window.x = map_to_window(v.ndc.x, viewport.half_width, viewport.center_x);
    v.window.y = map_to_window(-v.ndc.y, viewport.half_height, viewport.center_y);
    v.window.depth = std::fma(v.ndc.z, viewport.depth_scale, viewport.depth_offset);

    // Snap to 1/256 pixel
    const bool near_enough =
        std::fabs(v.window.x) < snap_limit && std::fabs(v.window.y) < snap_limit;
    if (!near_enough || !std::isfinite(v.window.depth)) {
        v.status = WindowStatus::too_far; // also where x, y or z overflowed to infinity or NaN
        return v;
    }
    v.fixed = {snap_by(viewport.snapping, v.window.x), snap_by(viewport.snapping, v.window.y)};
    v.status = WindowStatus::placed;
    return v;
}

} // namespace hs::geometry
