// What is drawn: objects that place meshes, a camera, lights, materials, and the frame's settings.
#pragma once

#include "core/scene/camera.hpp"
#include "core/scene/mesh.hpp"
#include "core/scene/settings.hpp"
#include "core/scene/texture.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hs::scene {

struct Material {
    std::string name;
    glm::vec4 diffuse{1.0F, 1.0F, 1.0F, 1.0F};
    glm::vec3 specular{0.0F, 0.0F, 0.0F};
    float shininess = 32.0F;                  ///< >= 0
    std::shared_ptr<const Texture> texture{}; ///< may be null
};

enum class LightKind : std::uint8_t {
    directional,
    point,
    ambient
};

struct Light {
    LightKind kind = LightKind::directional;
    glm::vec3 to_light{0.0F, 0.0F, 1.0F}; ///< directional: world space, any length but 0
    glm::vec3 position{0.0F, 0.0F, 0.0F}; ///< point: world space
    glm::vec3 color{1.0F, 1.0F, 1.0F};
};

/// One elementary transform, kept as written so that panels can show the steps and what-if can
/// change one number.
struct TransformStep {
    enum class Kind : std::uint8_t {
        translate,
        rotate,
        scale,
        matrix
    };
    Kind kind = Kind::translate;
    glm::vec3 vector{
        0.0F, 0.0F, 0.0F};  ///< translation, scale factors, or rotation axis (any length but 0)
    float degrees = 0.0F;   ///< rotation only
    glm::mat4 matrix{1.0F}; ///< Kind::matrix only
};

/// An instance of a mesh. Several objects may share one mesh.
struct Object {
    std::string name;
    std::shared_ptr<const Mesh> mesh; ///< never null
    std::optional<std::size_t> material;
    std::vector<TransformStep> transform; ///< applied right to left, like the matrices they are
    std::vector<std::pair<std::string, SettingValue>>
        overrides; ///< per-object settings, already checked
};

struct Scene {
    std::string name;
    std::string file;               ///< where it came from, "" when made by code
    std::vector<std::string> files; ///< every mesh and image it refers to, as resolved paths
    Settings settings;
    Camera camera;
    std::vector<Object> objects;
    std::vector<Material> materials;
    std::vector<Light> lights;
};

/// The product of an object's transform steps: object space to world space.
glm::mat4 object_to_world(const Object& object);

/// The frame's settings with the object's overrides applied.
Settings object_settings(const Scene& scene, const Object& object);

/// Of all primitives over all objects, in file order: the number that `triangle` exports and step
/// paths count with is per object.
std::size_t triangle_count(const Scene& scene);

} // namespace hs::scene

namespace hs {
template <>
std::span<const Named<scene::LightKind>> names<scene::LightKind>();
} // namespace hs
