#include "core/explain/eye_planes.hpp"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

namespace hs::explain {
namespace {

bool has_eye(const scene::Camera& camera) {
    return camera.projection.kind == scene::ProjectionKind::perspective ||
           camera.projection.kind == scene::ProjectionKind::frustum;
}

/// Through the pixel's center, into the scene.
std::optional<glm::vec3> ray_through(const pipeline::DrawCall& call, PixelPos p) {
    const glm::dmat4 projection{call.vertex.transforms.projection.matrix};
    if (glm::determinant(projection) == 0.0) {
        return std::nullopt;
    }
    const geometry::Viewport& viewport = call.viewport;
    const double x = p.x + 0.5 - static_cast<double>(viewport.center_x);
    const double y = p.y + 0.5 - static_cast<double>(viewport.center_y);
    constexpr double between_near_and_far = 0.5; // whatever the convention
    const glm::dvec4 point =
        glm::inverse(projection) * glm::dvec4{
                                       x / static_cast<double>(viewport.half_width),
                                       -y / static_cast<double>(viewport.half_height),
                                       between_near_and_far,
                                       1.0};
    return glm::vec3{glm::normalize(glm::dvec3{point} / point.w)};
}

} // namespace

std::optional<PlanesThroughEye> planes_through_eye(
    const trace::Recording& recording, const trace::StepDetail& detail, const trace::Step& step
) {
    const auto piece = static_cast<std::size_t>(step.piece);
    const bool ready = detail.triangle && step.kind >= trace::StepKind::setup &&
                       piece < detail.triangle->pieces.size() &&
                       detail.triangle->pieces[piece].planes;
    if (!ready || !has_eye(recording.scene().camera)) {
        return std::nullopt;
    }
    const pipeline::DrawCall& call = recording.frame->calls()[step.object];
    const pipeline::Transforms& t = call.vertex.transforms;
    std::array<glm::dvec3, 3> corners{};
    for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t vertex = detail.triangle->vertices[static_cast<int>(k)];
        corners[k] =
            glm::dvec3{t.view.matrix * (t.model.matrix * call.vertex.mesh->positions[vertex])};
    }
    PlanesThroughEye result;
    for (unsigned k = 0; k < 3; ++k) {
        const glm::dvec3& from = corners[k];
        const glm::dvec3& to = corners[(k + 1) % 3];
        const glm::dvec3 across = glm::cross(from, to);
        const double side = glm::dot(across, corners[(k + 2) % 3]);
        const double length = glm::length(across);
        if (side == 0.0 || length == 0.0) {
            return std::nullopt;
        }
        const double sign = side > 0.0 ? 1.0 : -1.0;
        result.planes[k] = {{glm::vec3{from}, glm::vec3{to}}, glm::vec3{across * (sign / length)}};
    }
    if (step.has_pixel()) {
        result.ray = ray_through(call, step.pixel);
    }
    return result;
}

} // namespace hs::explain
