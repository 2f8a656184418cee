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

/// `n` is the point's normal, of unit length or zero.
LightShare share_of(const EyeLight& light, const SurfacePoint& point, const glm::vec3& n) {
    LightShare share;
    share.kind = light.kind;
    share.color = light.color;
    const glm::vec3 surface{point.color};
    if (light.kind == scene::LightKind::ambient) {
        share.ambient = light.color * surface;
        return share;
    }

    // Diffuse: how squarely the light meets the surface
    share.to_light = light.kind == scene::LightKind::point
                         ? normalized_or_zero(light.position - point.position)
                         : light.to_light;
    share.n_dot_l = glm::dot(n, share.to_light);
    if (share.n_dot_l <= 0.0F) {
        return share; // the light is behind the surface
    }
    share.diffuse = light.color * surface * share.n_dot_l;

    // Specular: how close the half vector comes to the normal; a surface without it is spared the
    // power
    if (point.specular == glm::vec3{0.0F}) {
        return share;
    }
    share.half = normalized_or_zero(share.to_light + point.to_viewer);
    share.n_dot_h = std::max(0.0F, glm::dot(n, share.half));
    if (share.n_dot_h > 0.0F) {
        share.specular = light.color * point.specular * std::pow(share.n_dot_h, point.shininess);
    }
    return share;
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
    const glm::vec3 n = normalized_or_zero(point.normal);
    for (const EyeLight& light : lights) {
        const LightShare share = share_of(light, point, n);
        terms.ambient += share.ambient;
        terms.diffuse += share.diffuse;
        terms.specular += share.specular;
    }
    terms.color = glm::vec4{terms.ambient + terms.diffuse + terms.specular, point.color.a};
    return terms;
}

std::vector<LightShare> light_shares(const SurfacePoint& point, std::span<const EyeLight> lights) {
    std::vector<LightShare> list;
    const glm::vec3 n = normalized_or_zero(point.normal);
    for (const EyeLight& light : lights) {
        list.push_back(share_of(light, point, n));
    }
    return list;
}

} // namespace hs::shading
