// Loose triangles in clip space as a scene with an identity camera, drawn by the whole pipeline.
#pragma once

#include "core/framebuffer/framebuffer.hpp"
#include "core/scene/scene.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace hs::tests {

struct Corner {
    glm::vec4 clip;
    glm::vec4 color{1.0F};
    glm::vec2 uv{0.0F};
};

/// Three corners per triangle.
using Soup = std::vector<Corner>;

std::shared_ptr<const scene::Scene> soup_scene(
    const Soup& soup,
    const scene::Settings& settings,
    std::shared_ptr<const scene::Texture> texture = nullptr
);

/// A finished frame.
struct Drawing {
    framebuffer::Framebuffer target;
    std::vector<int> triangle; ///< per pixel, the one written last, counted over all objects; or −1
    std::vector<int> covered;                 ///< per pixel, the number of fragments
    std::vector<std::vector<glm::vec4>> clip; ///< per object, every vertex after the vertex stage

    [[nodiscard]] PixelPos pixel(std::size_t index) const {
        const auto i = static_cast<int>(index);
        return {i % target.width(), i / target.width()};
    }
};

/// Where a pixel is sampled, in pixels.
inline glm::dvec2 center(PixelPos pixel) {
    return {pixel.x + 0.5, pixel.y + 0.5};
}

Drawing drawn(const std::shared_ptr<const scene::Scene>& scene);

/// A stored depth as the integer of its format, or the bits of the float.
std::uint32_t raw_depth(float stored, scene::DepthFormat format);

} // namespace hs::tests
