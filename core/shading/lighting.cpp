#include "core/shading/lighting.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hs::shading {
namespace {

glm::vec3 normalized_or_zero(const glm::vec3& v) {
    const float length = glm::length(v);
    return length > 0.0F ? v / length : glm::vec3{0.0F};
}

} // namespace

std::vector<EyeLight>
lights_in_eye_space(std::span<const scene::Light> lights, const glm::mat4& view) {
    std::vector<EyeLight> result;
    for (const scene::Light& light : lights) {
        result.push_back({
            .kind = light.kind,
            .to_light = normalized_or_zero(glm::vec3{view * glm::vec4{light.to_light, 0.0F}}),
            .position = glm::vec3{view * glm::vec4{light.position, 1.0F}},
            .color = light.color,
        });
    }
    return result;
}

LightingTerms light_surface(const SurfacePoint& point, std::span<const EyeLight> lights) {
    LightingTerms terms;
    const glm::vec3 surface{point.color};
    const glm::vec3 n = normalized_or_zero(point.normal);
    for (const EyeLight& light : lights) {
        if (light.kind == scene::LightKind::ambient) {
            terms.ambient += light.color * surface;
            continue;
        }

        // Diffuse: how squarely the light meets the surface
        const glm::vec3 l = light.kind == scene::LightKind::point
                                ? normalized_or_zero(light.position - point.position)
                                : light.to_light;
        const float n_dot_l = glm::dot(n, l);
        if (n_dot_l <= 0.0F) {
            continue; // the light is behind the surface
        }
        terms.diffuse += light.color * surface * n_dot_l;

        // Specular: how close the half vector comes to the normal; a surface without it is spared
        // the power
        if (point.specular == glm::vec3{0.0F}) {
            continue;
        }
        const float n_dot_h = std::max(0.0F, glm::dot(n, normalized_or_zero(l + point.to_viewer)));
        if (n_dot_h > 0.0F) {
            terms.specular += light.color * point.specular * std::pow(n_dot_h, point.shininess);
        }
    }
    terms.color = glm::vec4{terms.ambient + terms.diffuse + terms.specular, point.color.a};
    return terms;
}

} // namespace hs::shading
