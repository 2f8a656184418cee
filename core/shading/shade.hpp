// The fragment stage's fixed shading: from interpolated varyings to a color.
#pragma once

#include "core/math/varyings.hpp"
#include "core/scene/scene.hpp"
#include "core/shading/lighting.hpp"
#include "core/shading/texture_lookup.hpp"

#include <glm/vec4.hpp>

#include <optional>
#include <span>

namespace hs::shading {

/// Everything shading needs that is the same for a whole draw.
struct ShadingInputs {
    scene::Shading shading = scene::Shading::unlit;
    math::VaryingLayout layout;
    const scene::Texture* texture = nullptr; ///< null: untextured
    glm::vec3 specular{0.0F};
    float shininess = 32.0F;
    bool orthographic = false; ///< the viewer is a direction, not a point
    float forward = -1.0F;     ///< the direction of sight in eye space, along z
    std::span<const EyeLight> lights;
};

/// What shading computed, kept for panels.
struct ShadedFragment {
    glm::vec4 color{0.0F};              ///< not clamped
    std::optional<TexelPos> texel;      ///< where the texture was read
    std::optional<LightingTerms> terms; ///< per-fragment lighting only
};

/// Unit vector from a point in eye space to the viewer.
glm::vec3 to_viewer(const ShadingInputs& in, const glm::vec3& eye_position);

/// What is lit at a fragment. Precondition: the layout has normal and position.
inline SurfacePoint
surface_at(const ShadingInputs& in, const math::Varyings& varyings, const glm::vec4& color) {
    const glm::vec3 position = varyings.vec3_at(in.layout.eye_position);
    return {
        .position = position,
        .normal = varyings.vec3_at(in.layout.normal),
        .to_viewer = to_viewer(in, position),
        .color = color,
        .specular = in.specular,
        .shininess = in.shininess};
}

/// Surface color = interpolated color × texel; with Phong shading it is lit here, otherwise it was
/// lit (or not) before. Gouraud and flat colors are lit per vertex and then modulated, specular
/// part included, as OpenGL's fixed pipeline did.
[[gnu::always_inline]] inline ShadedFragment
shade(const ShadingInputs& in, const math::Varyings& varyings) {
    ShadedFragment result;
    result.color = varyings.color();
    if (in.texture != nullptr) {
        const TexelPos texel = nearest_texel(*in.texture, varyings.vec2_at(in.layout.uv));
        result.texel = texel;
        result.color *= in.texture->texel(texel.i, texel.j);
    }
    if (in.shading == scene::Shading::phong) {
        result.terms = light_surface(surface_at(in, varyings, result.color), in.lights);
        result.color = result.terms->color;
    }
    return result;
}

} // namespace hs::shading
