#include "core/explain/lighting.hpp"

#include "core/explain/numbers.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace hs::explain {
namespace {

std::string rgb(const glm::vec3& color) {
    return point(color.r, color.g, color.b);
}

std::string direction(const glm::vec3& v) {
    return point(v.x, v.y, v.z);
}

Formula sum_formula(const shading::LightingTerms& terms) {
    return {
        "Blinn–Phong lighting",
        "color = ambient + Σ diffuse·max(n·l, 0) + specular·max(n·h, 0)^s",
        fmt::format(
            "ambient  {}\ndiffuse  {}\nspecular {}",
            rgb(terms.ambient),
            rgb(terms.diffuse),
            rgb(terms.specular)
        ),
        point(terms.color)};
}

Formula ambient_formula(
    std::size_t number, const shading::LightShare& share, const shading::SurfacePoint& surface
) {
    return {
        fmt::format("light {}: ambient", number),
        "ambient = light·surface, whatever the normal",
        fmt::format("{} · {}", rgb(share.color), rgb(glm::vec3{surface.color})),
        rgb(share.ambient)};
}

std::string diffuse_numbers(
    const shading::LightShare& share, const shading::SurfacePoint& surface, const glm::vec3& normal
) {
    return fmt::format(
        "n = {}\nl = {}, n·l = {}\ndiffuse {} · {} · {}\n= {}",
        direction(normal),
        direction(share.to_light),
        number(share.n_dot_l),
        rgb(share.color),
        rgb(glm::vec3{surface.color}),
        number(share.n_dot_l),
        rgb(share.diffuse)
    );
}

std::string
specular_numbers(const shading::LightShare& share, const shading::SurfacePoint& surface) {
    if (surface.specular == glm::vec3{0.0F}) {
        return "specular: the surface has none";
    }
    return fmt::format(
        "h = {}, n·h = {}\nspecular {} · {} · {}^{}\n= {}",
        direction(share.half),
        number(share.n_dot_h),
        rgb(share.color),
        rgb(surface.specular),
        number(share.n_dot_h),
        number(surface.shininess),
        rgb(share.specular)
    );
}

Formula light_formula(
    std::size_t number_of_light,
    const shading::LightShare& share,
    const shading::SurfacePoint& surface
) {
    const float length = glm::length(surface.normal);
    const glm::vec3 normal = length > 0.0F ? surface.normal / length : glm::vec3{0.0F};
    Formula formula{
        fmt::format("light {}: {}", number_of_light, name_of(share.kind)),
        "light·surface·(n·l) + light·specular·(n·h)^s, h = (l + v)/|l + v|",
        "",
        rgb(share.diffuse + share.specular)};
    if (share.n_dot_l <= 0.0F) {
        formula.with_numbers = fmt::format(
            "n = {}\nl = {}, n·l = {}\nn·l ≤ 0: the light is behind the surface",
            direction(normal),
            direction(share.to_light),
            number(share.n_dot_l)
        );
        return formula;
    }
    formula.with_numbers =
        diffuse_numbers(share, surface, normal) + "\n" + specular_numbers(share, surface);
    return formula;
}

} // namespace

std::vector<Formula>
lighting_formulas(const shading::LightingTerms& terms, const trace::LitPoint& point) {
    std::vector<Formula> list{sum_formula(terms)};
    for (std::size_t i = 0; i < point.lights.size(); ++i) {
        const shading::LightShare& share = point.lights[i];
        const bool ambient = share.kind == scene::LightKind::ambient;
        list.push_back(
            ambient ? ambient_formula(i, share, point.surface)
                    : light_formula(i, share, point.surface)
        );
    }
    return list;
}

std::vector<Formula> mixed_color_formulas(
    const trace::TriangleDetail& triangle,
    const trace::FragmentDetail& fragment,
    const scene::Settings& settings
) {
    const bool per_vertex = settings.shading == scene::Shading::gouraud;
    if (!per_vertex || !triangle.passes.empty() ||
        settings.interpolation == scene::InterpolationKind::flat) {
        return {};
    }
    const bool perspective = settings.interpolation == scene::InterpolationKind::perspective;
    const auto& weights =
        perspective ? fragment.fragment.barycentric_clip : fragment.fragment.barycentric;
    std::string numbers;
    for (unsigned k = 0; k < 3; ++k) {
        const glm::vec4 color = triangle.corners[k].work.varyings.color();
        numbers += fmt::format("{}{} · {}", k == 0 ? "" : "\n+ ", number(weights[k]), point(color));
    }
    return {
        {"color lit at the vertices",
         perspective ? "color = b0·c0 + b1·c1 + b2·c2" : "color = λ0·c0 + λ1·c1 + λ2·c2",
         numbers,
         point(fragment.fragment.varyings.color())}};
}

} // namespace hs::explain
