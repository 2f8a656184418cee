#include "core/pipeline/frame.hpp"

#include "core/pipeline/fault.hpp"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace hs::pipeline {
namespace {

/// Color always; texture coordinates, normals and positions only where shading reads them.
math::VaryingLayout layout_for(const scene::Settings& settings, bool textured) {
    math::VaryingLayout layout;
    const auto reserve = [&layout](int floats) {
        const int start = layout.count;
        layout.count += floats;
        return start;
    };
    if (textured) {
        layout.uv = reserve(2);
    }
    if (settings.shading == scene::Shading::phong) {
        layout.normal = reserve(3);
        layout.eye_position = reserve(3);
    }
    return layout;
}

/// The inverse transpose. A model squashed flat (scale 0), or as good as flat in a float, has none
/// and loses its normals: ambient light only.
glm::mat3 normal_matrix(const glm::mat3& object_to_eye) {
    if (glm::determinant(object_to_eye) == 0.0F) {
        return glm::mat3{0.0F};
    }
    const glm::mat3 result = glm::transpose(glm::inverse(object_to_eye));
    const std::span<const float> entries(glm::value_ptr(result), 9);
    const bool finite = std::ranges::all_of(entries, [](float x) { return std::isfinite(x); });
    return finite ? result : glm::mat3{0.0F};
}

Transforms transforms_of(const scene::Scene& scene, const scene::Object& object) {
    const scene::Settings& settings = scene.settings;
    const PixelRect viewport = settings.viewport();
    const float aspect =
        static_cast<float>(viewport.width()) / static_cast<float>(viewport.height());
    Transforms t;
    t.model = {scene::object_to_world(object)};
    t.view = scene::view_transform(scene.camera);
    t.projection = scene::projection_transform(scene.camera, aspect, settings.depth_convention);
    t.normal = normal_matrix(glm::mat3{t.view.matrix * t.model.matrix});
    return t;
}

bool is_orthographic(const scene::Camera& camera) {
    return camera.projection.kind == scene::ProjectionKind::orthographic ||
           camera.projection.kind == scene::ProjectionKind::identity;
}

} // namespace

void DrawCall::place_vertex(std::size_t index, const geometry::ClipVertex& placed) {
    const auto stride = static_cast<std::size_t>(vertex.layout.count);
    std::copy_n(placed.varyings.values.begin(), stride, varyings.data() + index * stride);
    vertices[index] = {
        .clip = placed.position,
        .window = geometry::to_window(placed.position, viewport),
        .outcode = geometry::outcode(volume, placed.position),
    };
}

geometry::ClipVertex DrawCall::clip_vertex(std::size_t index) const {
    geometry::ClipVertex result{vertices[index].clip, {}};
    const auto stride = static_cast<std::size_t>(vertex.layout.count);
    std::copy_n(varyings_of(index), stride, result.varyings.values.begin());
    return result;
}

Frame::Frame(std::shared_ptr<const scene::Scene> scene)
    : scene_(std::move(scene)),
      lights_(
          shading::lights_in_eye_space(scene_->lights, scene::view_transform(scene_->camera).matrix)
      ) {
    static const scene::Material plain{};
    for (std::size_t i = 0; i < scene_->objects.size(); ++i) {
        const scene::Object& object = scene_->objects[i];
        const scene::Material& material =
            object.material ? scene_->materials[*object.material] : plain;
        const bool textured = material.texture != nullptr && !object.mesh->uvs.empty();

        DrawCall call;
        call.object = static_cast<std::uint32_t>(i);
        call.settings = scene::object_settings(*scene_, object);
        call.vertex.mesh = object.mesh.get();
        call.vertex.transforms = transforms_of(*scene_, object);
        call.vertex.layout = layout_for(call.settings, textured);
        call.vertex.diffuse = material.diffuse;
        call.vertex.shading = {
            .shading = call.settings.shading,
            .layout = call.vertex.layout,
            .texture = textured ? material.texture.get() : nullptr,
            .specular = material.specular,
            .shininess = material.shininess,
            .orthographic = is_orthographic(scene_->camera),
            .forward = scene::forward_sign(scene_->camera),
            .lights = lights_,
        };
        call.volume =
            geometry::clip_volume(call.settings, call.vertex.transforms.projection.matrix);
        call.viewport =
            geometry::make_viewport(call.settings.viewport(), call.settings.depth_convention);
        seed_fault(call);
        calls_.push_back(std::move(call));
    }
}

} // namespace hs::pipeline
