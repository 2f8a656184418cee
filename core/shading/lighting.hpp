// Blinn, Models of Light Reflection for Computer Synthesized Pictures, 1977: diffuse n·l, specular
// (n·h)^s with the half vector. Local viewer (the eye at the origin of eye space), no attenuation.
#pragma once

#include "core/scene/scene.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <span>
#include <vector>

namespace hs::shading {

/// A light in eye space.
struct EyeLight {
    scene::LightKind kind = scene::LightKind::directional;
    glm::vec3 to_light{0.0F, 0.0F, 1.0F}; ///< directional: unit vector
    glm::vec3 position{0.0F, 0.0F, 0.0F}; ///< point
    glm::vec3 color{1.0F, 1.0F, 1.0F};
};

std::vector<EyeLight>
lights_in_eye_space(std::span<const scene::Light> lights, const glm::mat4& view);

/// A point to be lit, everything in eye space.
struct SurfacePoint {
    glm::vec3 position;
    glm::vec3 normal;    ///< any length; a zero vector is lit by ambient light only
    glm::vec3 to_viewer; ///< unit vector: −position normalized, or +z for orthographic cameras
    glm::vec4 color;     ///< surface color: vertex color × diffuse × texel
    glm::vec3 specular;
    float shininess = 32.0F;
};

/// The terms kept apart, so that panels can show them. `color` is their sum with the surface's
/// alpha, not clamped.
struct LightingTerms {
    glm::vec3 ambient{0.0F};
    glm::vec3 diffuse{0.0F};
    glm::vec3 specular{0.0F};
    glm::vec4 color{0.0F};
};

/// What one light adds to a point, and the numbers behind it. What is not asked stays 0: all of it
/// where the light is behind the surface (n·l <= 0), the half vector where nothing is specular.
struct LightShare {
    scene::LightKind kind = scene::LightKind::directional;
    glm::vec3 color{0.0F};
    glm::vec3 to_light{0.0F}; ///< l
    glm::vec3 half{0.0F};     ///< h, halfway between l and the direction to the viewer
    float n_dot_l = 0.0F;
    float n_dot_h = 0.0F;
    glm::vec3 ambient{0.0F};
    glm::vec3 diffuse{0.0F};
    glm::vec3 specular{0.0F};
};

/// One after the other; their sums are what `light_surface` returns.
std::vector<LightShare> light_shares(const SurfacePoint& point, std::span<const EyeLight> lights);

LightingTerms light_surface(const SurfacePoint& point, std::span<const EyeLight> lights);

} // namespace hs::shading
