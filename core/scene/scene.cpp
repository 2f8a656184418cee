#include "core/scene/scene.hpp"

#include "core/base/check.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace hs::scene {

namespace {

struct SineCosine {
    float sine = 0.0F;
    float cosine = 1.0F;
};

/// Exact for quarter turns, so that a cube turned by 90 degrees has no 4e-8 in its matrix: the
/// angle is reduced to
/// [-45, 45] degrees, exactly, before it becomes radians.
SineCosine sine_cosine(float degrees) {
    int quarters = 0;
    const float rest = std::remquo(degrees, 90.0F, &quarters);
    const float radians = rest * (std::numbers::pi_v<float> / 180.0F);
    const float s = std::sin(radians);
    const float c = std::cos(radians);
    switch (static_cast<unsigned>(quarters) % 4U) {
    case 0: return {s, c};
    case 1: return {c, -s};
    case 2: return {-s, -c};
    default: return {-c, s};
    }
}

/// Rodrigues 1840: cos θ·I + (1 − cos θ)·a aᵀ + sin θ·[a]×, counter-clockwise when the axis points
/// at the beholder.
glm::mat4 rotation(const glm::vec3& axis, float degrees) {
    const glm::vec3 a = glm::normalize(axis);
    const auto [s, c] = sine_cosine(degrees);
    const float t = 1.0F - c;
    // clang-format off
    return { // column by column
        t * a.x * a.x + c,       t * a.x * a.y + s * a.z, t * a.x * a.z - s * a.y, 0.0F,
        t * a.x * a.y - s * a.z, t * a.y * a.y + c,       t * a.y * a.z + s * a.x, 0.0F,
        t * a.x * a.z + s * a.y, t * a.y * a.z - s * a.x, t * a.z * a.z + c,       0.0F,
        0.0F,                    0.0F,                    0.0F,                    1.0F,
    };
    // clang-format on
}

glm::mat4 matrix_of(const TransformStep& step) {
    glm::mat4 m{1.0F};
    switch (step.kind) {
    case TransformStep::Kind::translate: m[3] = glm::vec4{step.vector, 1.0F}; return m;
    case TransformStep::Kind::rotate: return rotation(step.vector, step.degrees);
    case TransformStep::Kind::scale:
        for (int i = 0; i < 3; ++i) {
            m[i][i] = step.vector[i];
        }
        return m;
    case TransformStep::Kind::matrix: return step.matrix;
    }
    HS_CHECK(false, "every kind of transform is handled");
    return m;
}

} // namespace

glm::mat4 object_to_world(const Object& object) {
    glm::mat4 product{1.0F};
    for (const TransformStep& step : object.transform) {
        product = product * matrix_of(step);
    }
    return product;
}

Settings object_settings(const Scene& scene, const Object& object) {
    Settings settings = scene.settings;
    for (const auto& [key, value] : object.overrides) {
        HS_CHECK(!assign(settings, key, value), "overrides are checked when the scene is loaded");
    }
    return settings;
}

std::size_t triangle_count(const Scene& scene) {
    std::size_t count = 0;
    for (const Object& object : scene.objects) {
        count += object.mesh->primitive_count();
    }
    return count;
}

} // namespace hs::scene

namespace hs {

namespace {

constexpr Named<scene::LightKind> light_names[] = {
    {scene::LightKind::directional,
     "directional",
     "parallel light from a source infinitely far away in the direction to_light"},
    {scene::LightKind::point,
     "point",
     "light from one position in all directions, not weakened by distance"},
    {scene::LightKind::ambient,
     "ambient",
     "light that reaches every surface equally, from everywhere"},
};

} // namespace

template <>
std::span<const Named<scene::LightKind>> names<scene::LightKind>() {
    return light_names;
}

} // namespace hs
