#include "core/pipeline/vertex_stage.hpp"

namespace hs::pipeline {
namespace {

glm::vec4 surface_color(const VertexInputs& in, std::uint32_t vertex) {
    const glm::vec4 color = in.mesh->colors.empty() ? glm::vec4{1.0F} : in.mesh->colors[vertex];
    return color * in.diffuse;
}

} // namespace

VertexWork run_vertex(const VertexInputs& in, std::uint32_t vertex) {
    VertexWork work;

    // Object to world to eye to clip: three matrices, one after the other, each a step to look at
    work.object = math::to_position<math::ObjectSpace>(in.mesh->positions[vertex]);
    work.world = in.transforms.model(work.object);
    work.eye = in.transforms.view(work.world);
    work.clip = in.transforms.projection(work.eye);

    // Gather what the rasterizer will interpolate
    const glm::vec3 eye_position{work.eye.x, work.eye.y, work.eye.z};
    work.varyings.set(0, surface_color(in, vertex));
    if (in.layout.uv >= 0) {
        work.varyings.set(in.layout.uv, in.mesh->uvs[vertex]);
    }
    const bool lit = in.shading.shading == scene::Shading::gouraud || in.layout.normal >= 0;
    const glm::vec3 normal =
        lit ? in.transforms.normal * in.mesh->normals[vertex] : glm::vec3{0.0F};
    if (in.layout.normal >= 0) {
        work.varyings.set(in.layout.normal, normal);
        work.varyings.set(in.layout.eye_position, eye_position);
    }

    // Light the vertex
    if (in.shading.shading == scene::Shading::gouraud) {
        work.terms = shading::light_surface(
            {.position = eye_position,
             .normal = normal,
             .to_viewer = shading::to_viewer(in.shading, eye_position),
             .color = work.varyings.color(),
             .specular = in.shading.specular,
             .shininess = in.shading.shininess},
            in.shading.lights
        );
        work.varyings.set(0, work.terms->color);
    }
    return work;
}

} // namespace hs::pipeline
