// The values of lighting, in the order of shading/lighting.cpp: what each light adds to a point.
#include "core/explain/value_list.hpp"

#include <fmt/format.h>

#include <cmath>

namespace hs::explain {
namespace {

const Operation square_root{"√", 0, UnitRule::first, [](std::span<const Number> n) -> Number {
                                return std::sqrt(std::get<float>(n[0]));
                            }};
const Operation power{"pow", 0, UnitRule::none, [](std::span<const Number> n) -> Number {
                          return std::pow(std::get<float>(n[0]), std::get<float>(n[1]));
                      }};

Triple triple(const Real& x, const Real& y, const Real& z) {
    return {x, y, z};
}

Real dot(const Triple& a, const Triple& b) {
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

Triple
add_triple(ValueList& list, const std::string& name, const std::array<const char*, 4>& parts, const Triple& v) {
    const auto part = [&](unsigned k) {
        return list.add(fmt::format("{}.{}", name, parts[k]), v[k]);
    };
    return triple(part(0), part(1), part(2));
}

/// The vector with length one; zero stays zero.
Triple add_unit(ValueList& list, const std::string& name, const Triple& v) {
    const Real length = list.add("|" + name + "|", call<float>(square_root, dot(v, v)));
    if (!(length.value() > 0.0F)) {
        return add_triple(list, name, axis_names, triple(0.0F, 0.0F, 0.0F));
    }
    return add_triple(
        list, name, axis_names, triple(v[0] / length, v[1] / length, v[2] / length)
    );
}

Triple given(const std::string& name, const glm::vec3& v, const std::string& where) {
    const auto part = [&](unsigned k, float number, const std::array<const char*, 4>& parts) {
        return operand(fmt::format("{}.{}", name, parts[k]), number, {{}, {}, where});
    };
    const bool color = name.ends_with("color") || name == "specular";
    const auto& parts = color ? channel_names : axis_names;
    return triple(part(0, v.x, parts), part(1, v.y, parts), part(2, v.z, parts));
}

/// From the point to the eye; against the direction of sight where that is one for all points.
Triple add_to_viewer(ValueList& list, const shading::ShadingInputs& in, const Triple& position) {
    const Real distance = list.add("|position|", call<float>(square_root, dot(position, position)));
    if (in.orthographic || distance.value() == 0.0F) {
        return given("v", {0.0F, 0.0F, -in.forward}, "camera.projection");
    }
    return add_triple(
        list,
        "v",
        axis_names,
        triple(-position[0] / distance, -position[1] / distance, -position[2] / distance)
    );
}

/// What lighting adds up, light by light.
struct Sums {
    Triple ambient = triple(0.0F, 0.0F, 0.0F);
    Triple diffuse = triple(0.0F, 0.0F, 0.0F);
    Triple specular = triple(0.0F, 0.0F, 0.0F);
};

void add_to(Triple& sum, const Triple& share) {
    sum = triple(sum[0] + share[0], sum[1] + share[1], sum[2] + share[2]);
}

/// The point that is lit.
struct Lit {
    Triple position;
    Triple n; ///< of unit length or zero
    Triple color;
    Triple to_viewer;
};

void add_light(
    ValueList& list,
    Sums& sums,
    const shading::EyeLight& light,
    const std::string& name,
    const Lit& point,
    const shading::ShadingInputs& in
) {
    const std::string entry = "light." + name.substr(name.find(' ') + 1);
    const Triple color = given(name + " color", light.color, entry + ".color");
    const auto colored = [&](unsigned k) { return color[k] * point.color[k]; };
    if (light.kind == scene::LightKind::ambient) {
        add_to(
            sums.ambient,
            add_triple(
                list, name + " ambient", channel_names, triple(colored(0), colored(1), colored(2))
            )
        );
        return;
    }

    // Diffuse: how squarely the light meets the surface
    Triple l = given(name + " l", light.to_light, entry + ".to_light, in eye space");
    if (light.kind == scene::LightKind::point) {
        const Triple place = given(name + " place", light.position, entry + ".position, in eye space");
        const auto toward = [&](unsigned k) { return place[k] - point.position[k]; };
        l = add_unit(list, name + " l", triple(toward(0), toward(1), toward(2)));
    }
    const Real n_dot_l = list.add(name + " n·l", dot(point.n, l));
    if (n_dot_l.value() <= 0.0F) {
        return; // the light is behind the surface
    }
    const auto lit = [&](unsigned k) { return colored(k) * n_dot_l; };
    add_to(
        sums.diffuse,
        add_triple(list, name + " diffuse", channel_names, triple(lit(0), lit(1), lit(2)))
    );

    // Specular: how close the half vector comes to the normal
    if (in.specular == glm::vec3{0.0F}) {
        return;
    }
    const auto between = [&](unsigned k) { return l[k] + point.to_viewer[k]; };
    const Triple h = add_unit(list, name + " h", triple(between(0), between(1), between(2)));
    const Real n_dot_h =
        list.add(name + " n·h", call<float>(operations::larger, Real{0.0F}, dot(point.n, h)));
    if (!(n_dot_h.value() > 0.0F)) {
        return;
    }
    const Triple specular = given("specular", in.specular, "material.specular");
    const Real shininess = operand("shininess", in.shininess, {{}, {}, "material.shininess"});
    const auto shining = [&](unsigned k) {
        return color[k] * specular[k] * call<float>(power, n_dot_h, shininess);
    };
    add_to(
        sums.specular,
        add_triple(
            list, name + " specular", channel_names, triple(shining(0), shining(1), shining(2))
        )
    );
}

} // namespace

void add_lighting(
    ValueList& list, const pipeline::DrawCall& call, const SurfaceTerms& surface, std::string_view prefix
) {
    const shading::ShadingInputs& in = call.vertex.shading;
    const Lit point{
        .position = surface.position,
        .n = add_unit(list, "n", surface.normal),
        .color = surface.color,
        .to_viewer = add_to_viewer(list, in, surface.position)};
    Sums sums;
    for (std::size_t i = 0; i < in.lights.size(); ++i) {
        add_light(list, sums, in.lights[i], fmt::format("light {}", i), point, in);
    }
    const Triple ambient = add_triple(list, "ambient", channel_names, sums.ambient);
    const Triple diffuse = add_triple(list, "diffuse", channel_names, sums.diffuse);
    const Triple specular = add_triple(list, "specular", channel_names, sums.specular);
    for (unsigned k = 0; k < 3; ++k) {
        list.add(
            fmt::format("{}{}", prefix, channel_names[k]), (ambient[k] + diffuse[k]) + specular[k]
        );
    }
}

} // namespace hs::explain
