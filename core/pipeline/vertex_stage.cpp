#include "core/pipeline/vertex_stage.hpp"

namespace hs::pipeline {
namespace {

glm::vec4 surface_color(const VertexInputs& in, std::uint32_t vertex) {
    const glm::vec4 color = in.mesh->colors.empty() ? glm::vec4{1.0F} : in.mesh->colors[vertex];
    return color * in.diffuse;
}

} // namespace

shading::SurfacePoint
vertex_surface(const VertexInputs& in, std::uint32_t vertex, const math::EyePosition& eye) {
    const glm::vec3 position{eye.x, eye.y, eye.z};
    return {
        .position = position,
        .normal = in.transforms.normal * in.mesh->normals[vertex],
        .to_viewer = shading::to_viewer(in.shading, position),
        .color = surface_color(in, vertex),
        .specular = in.shading.specular,
        .shininess = in.shading.shininess};
}

VertexWork run_vertex(const VertexInputs& in, std::uint32_t vertex) {
    VertexWork work;

    // Object to world to eye to clip: three matrices, one after the other, each a step to look at
    work.object = math::to_position<math::ObjectSpace>(in.mesh->positions[vertex]);
    work.world = in.transforms.model(work.object);
    work.eye = in.transforms.view(work.world);
    work.clip = in.transforms.projection(work.eye);

    // Gather what the rasterizer will interpolate
    work.varyings.set(0, surface_color(in, vertex));
    if (in.layout.uv >= 0) {
        work.varyings.set(in.layout.uv, in.mesh->uvs[vertex]);
    }
    if (in.layout.normal >= 0) {
        work.varyings.set(in.layout.normal, in.transforms.normal * in.mesh->normals[vertex]);
        work.varyings.set(in.layout.eye_position, glm::vec3{work.eye.x, work.eye.y, work.eye.z});
    }

    // Light the vertex
    if (in.shading.shading == scene::Shading::gouraud) {
        work.terms =
            shading::light_surface(vertex_surface(in, vertex, work.eye), in.shading.lights);
        work.varyings.set(0, work.terms->color);
    }
    return work;
}

} // namespace hs::pipeline
