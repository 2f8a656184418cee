// One triangle from clip space to covered pixels through the pipeline's own functions, without the
// rest of the pipeline around them.
#pragma once

#include "core/geometry/facing.hpp"
#include "core/geometry/viewport.hpp"
#include "core/raster/traverse.hpp"

#include <glm/vec4.hpp>

#include <array>
#include <optional>
#include <span>

namespace hs::tests {

inline std::array<geometry::WindowVertex, 3>
placed(std::span<const glm::vec4> corners, const geometry::Viewport& viewport) {
    const auto place = [&](std::size_t k) {
        return geometry::to_window(math::to_position<math::ClipSpace>(corners[k]), viewport);
    };
    return {place(0), place(1), place(2)};
}

/// Empty for a triangle without area or with a vertex that has no place in the window.
inline std::optional<raster::TriangleSetup>
setup_of(const std::array<geometry::WindowVertex, 3>& v, const PixelRect& image) {
    for (const geometry::WindowVertex& vertex : v) {
        if (vertex.status != geometry::WindowStatus::placed) {
            return std::nullopt;
        }
    }
    const std::int64_t area = geometry::doubled_area(v[0].fixed, v[1].fixed, v[2].fixed);
    if (area == 0) {
        return std::nullopt;
    }
    return raster::set_up({v[0].fixed, v[1].fixed, v[2].fixed}, area, image);
}

/// `emit(pixel, edge values)` for every pixel the triangle covers.
template <typename Emit>
void rasterize(
    const std::optional<raster::TriangleSetup>& setup,
    const PixelRect& image,
    scene::TraversalKind kind,
    Emit&& emit
) {
    if (setup) {
        raster::SilentTraversal silent;
        raster::traverse({kind}, *setup, image, {}, silent, emit);
    }
}

} // namespace hs::tests
