#include "app/bench/workload.hpp"

#include "core/base/check.hpp"
#include "core/scene/mesh_file.hpp"
#include "core/scene/shapes.hpp"
#include "core/scene/triangulate.hpp"

#include <array>

namespace hs::bench {
Subject knot(const std::string& name, int triangles) {
    Result<scene::Mesh> mesh = scene::make_shape("torus-knot", {.triangles = triangles});
    HS_CHECK(mesh, "a torus knot can be made with any number of triangles");
    return {name, std::make_shared<const scene::Mesh>(std::move(*mesh))};
}

Subject mesh_file(const std::string& name, const std::filesystem::path& file) {
    Result<scene::Mesh> mesh = scene::load_mesh(file);
    if (!mesh) {
        return {name, nullptr};
    }
    scene::fit_to_unit_sphere(*mesh);
    return {name, std::make_shared<const scene::Mesh>(std::move(*mesh))};
}

std::shared_ptr<scene::Scene> scene_of(const Subject& subject, const ImageSize& size) {
    const Light light;
    auto scene = std::make_shared<scene::Scene>();
    scene->name = subject.name;
    scene->settings.width = size.width;
    scene->settings.height = size.height;
    scene->settings.background = {0.0F, 0.0F, 0.0F, 0.0F};
    scene->settings.shading = scene::Shading::gouraud;
    scene->settings.cull = scene::CullFace::back;
    scene->camera.eye = {0.0F, 0.0F, 2.7F};
    scene->lights.push_back({.to_light = light.to_light, .color = glm::vec3{1.0F - light.ambient}});
    scene->lights.push_back({.kind = scene::LightKind::ambient, .color = glm::vec3{light.ambient}});
    scene->materials.push_back({.name = "clay", .diffuse = {light.color, 1.0F}});
    scene::Object object;
    object.name = subject.name;
    object.mesh = subject.mesh;
    object.material = 0;
    scene->objects.push_back(std::move(object));
    return scene;
}

std::shared_ptr<const scene::Scene> sheets(int count, const ImageSize& size) {
    constexpr std::array corners{
        glm::vec2{-1.0F, -1.0F},
        glm::vec2{1.0F, -1.0F},
        glm::vec2{1.0F, 1.0F},
        glm::vec2{-1.0F, 1.0F}};
    auto mesh = std::make_shared<scene::Mesh>();
    for (int i = 0; i < count; ++i) {
        const float z = 1.0F - 2.0F * (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
        const auto first = static_cast<std::uint32_t>(mesh->positions.size());
        for (const glm::vec2& corner : corners) {
            mesh->positions.emplace_back(corner, z, 1.0F);
            mesh->normals.emplace_back(0.0F, 0.0F, 1.0F);
        }
        mesh->triangles.push_back({first, first + 1, first + 2});
        mesh->triangles.push_back({first, first + 2, first + 3});
    }
    mesh->triangle_polygon.resize(mesh->triangles.size());
    auto scene = scene_of({"sheets", std::move(mesh)}, size);
    scene->camera.projection.kind = scene::ProjectionKind::identity;
    return scene;
}

glm::mat4 clip_from_object(const scene::Scene& scene) {
    const scene::Settings& settings = scene.settings;
    const float aspect = static_cast<float>(settings.width) / static_cast<float>(settings.height);
    const auto projection =
        scene::projection_transform(scene.camera, aspect, settings.depth_convention);
    return projection.matrix * scene::view_transform(scene.camera).matrix;
}

} // namespace hs::bench
