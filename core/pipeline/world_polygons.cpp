#include "core/pipeline/world_polygons.hpp"

#include <fmt/format.h>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

namespace hs::pipeline {
namespace {

math::WorldPosition world_position(const DrawCall& call, std::uint32_t vertex) {
    return call.vertex.transforms.model(
        math::to_position<math::ObjectSpace>(call.vertex.mesh->positions[vertex])
    );
}

} // namespace

std::vector<visibility::WorldPolygon> world_polygons(const Frame& frame) {
    std::vector<visibility::WorldPolygon> polygons;
    for (const DrawCall& call : frame.calls()) {
        for (const scene::TriangleIndices& indices : call.triangles()) {
            visibility::WorldPolygon polygon;
            polygon.triangle = static_cast<std::uint32_t>(polygons.size());
            for (int corner = 0; corner < 3; ++corner) {
                const math::WorldPosition p = world_position(call, indices[corner]);
                glm::dvec3 weights{0.0};
                weights[corner] = 1.0;
                polygon.corners.push_back(
                    {.position = glm::dvec3{glm::vec3{p.x, p.y, p.z}}, .weights = weights}
                );
            }
            polygons.push_back(std::move(polygon));
        }
    }
    return polygons;
}

std::optional<std::string> complaint_about_world(const Frame& frame) {
    for (const DrawCall& call : frame.calls()) {
        const auto count = static_cast<std::uint32_t>(call.vertex.mesh->positions.size());
        for (std::uint32_t vertex = 0; vertex < count; ++vertex) {
            const math::WorldPosition p = world_position(call, vertex);
            if (p.w != 1.0F) {
                return fmt::format(
                    "visibility \"{}\" {} triangles in the world, where a vertex needs w = 1; "
                    "vertex {} of object {} has w = {}",
                    name_of(frame.settings().visibility),
                    frame.settings().sweeps() ? "meets" : "orders",
                    vertex,
                    call.object,
                    p.w
                );
            }
        }
    }
    return std::nullopt;
}

glm::dvec4 eye_in_world(const Frame& frame) {
    if (frame.calls().empty()) {
        return {0.0, 0.0, 1.0, 0.0};
    }
    const Transforms& t = frame.calls().front().vertex.transforms;
    const glm::dmat4 world_to_clip = glm::dmat4{t.projection.matrix} * glm::dmat4{t.view.matrix};
    const bool reversed = frame.settings().depth_convention == scene::DepthConvention::reversed;
    const glm::dvec4 toward_eye{0.0, 0.0, reversed ? 1.0 : -1.0, 0.0};
    const glm::dvec4 eye = glm::inverse(world_to_clip) * toward_eye;
    if (frame.calls().front().vertex.shading.orthographic) {
        return {glm::dvec3{eye}, 0.0};
    }
    return eye / eye.w;
}

} // namespace hs::pipeline
