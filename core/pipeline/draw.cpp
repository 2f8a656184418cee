#include "core/pipeline/draw.hpp"

#include <glm/geometric.hpp>

namespace hs::pipeline {
namespace {

glm::vec3 eye_position(const DrawCall& call, std::uint32_t vertex) {
    const Transforms& t = call.vertex.transforms;
    const math::EyePosition eye =
        t.view(t.model(math::to_position<math::ObjectSpace>(call.vertex.mesh->positions[vertex])));
    return {eye.x, eye.y, eye.z};
}

/// Lit once for the whole triangle.
glm::vec4 flat_color(const DrawCall& call, const scene::TriangleIndices& indices) {
    const glm::vec3 p0 = eye_position(call, indices.a);
    const glm::vec3 p1 = eye_position(call, indices.b);
    const glm::vec3 p2 = eye_position(call, indices.c);
    const bool ccw = call.settings.front_face == scene::Winding::ccw;
    const glm::vec3 normal = glm::cross(p1 - p0, p2 - p0) * (ccw ? 1.0F : -1.0F);

    const shading::LightingTerms terms = shading::light_surface(
        {.position = p2,
         .normal = normal,
         .to_viewer = shading::to_viewer(call.vertex.shading, p2),
         .color = call.clip_vertex(indices.c).varyings.color(),
         .specular = call.vertex.shading.specular,
         .shininess = call.vertex.shading.shininess},
        call.vertex.shading.lights
    );
    return terms.color;
}

} // namespace

geometry::ClipPolygon assemble(const DrawCall& call, const scene::TriangleIndices& indices) {
    geometry::ClipPolygon polygon;
    for (int corner = 0; corner < 3; ++corner) {
        polygon.add(call.clip_vertex(indices[corner]));
    }
    if (call.settings.shading == scene::Shading::flat) {
        const glm::vec4 color = flat_color(call, indices);
        for (unsigned corner = 0; corner < 3; ++corner) {
            polygon.vertices[corner].varyings.set(0, color); // texture coordinates still vary
        }
    }
    if (call.settings.interpolation == scene::InterpolationKind::flat) {
        const math::Varyings provoking = polygon[2].varyings;
        for (unsigned corner = 0; corner < 3; ++corner) {
            polygon.vertices[corner].varyings = provoking;
        }
    }
    return polygon;
}

ShadedPart
assemble(const DrawCall& call, const scene::TriangleIndices& indices, const TrianglePart& part) {
    const geometry::ClipPolygon whole = assemble(call, indices);
    const auto mixed = [&whole](const glm::dvec3& weights, const auto& value_of) {
        return static_cast<float>(
            weights[0] * static_cast<double>(value_of(whole[0])) +
            weights[1] * static_cast<double>(value_of(whole[1])) +
            weights[2] * static_cast<double>(value_of(whole[2]))
        );
    };
    ShadedPart result;
    for (unsigned corner = 0; corner < 3; ++corner) {
        const glm::dvec3& weights = part.weights[corner];
        geometry::ClipVertex vertex;
        vertex.position = {
            mixed(weights, [](const geometry::ClipVertex& v) { return v.position.x; }),
            mixed(weights, [](const geometry::ClipVertex& v) { return v.position.y; }),
            mixed(weights, [](const geometry::ClipVertex& v) { return v.position.z; }),
            mixed(weights, [](const geometry::ClipVertex& v) { return v.position.w; })};
        for (int i = 0; i < call.vertex.layout.count; ++i) {
            vertex.varyings[i] =
                mixed(weights, [i](const geometry::ClipVertex& v) { return v.varyings[i]; });
        }
        result.outcodes[corner] = geometry::outcode(call.volume, vertex.position);
        result.polygon.add(vertex);
    }
    return result;
}

} // namespace hs::pipeline
