#include "app/viewer/space_map.hpp"

#include <glm/matrix.hpp>

#include <cmath>

namespace hs::viewer {
namespace {

/// A point after its divide by w; empty behind the eye and where it is out of any picture.
std::optional<glm::vec3> with_place(const glm::vec4& v) {
    constexpr float smallest = 1.0e-6F;
    if (!(v.w > smallest)) {
        return std::nullopt;
    }
    const glm::vec3 p = glm::vec3{v.x, v.y, v.z} / v.w;
    constexpr float largest = 1.0e6F;
    const bool finite =
        std::fabs(p.x) < largest && std::fabs(p.y) < largest && std::fabs(p.z) < largest;
    return finite ? std::optional{p} : std::nullopt;
}

std::optional<glm::vec3> checked(const std::optional<glm::vec3>& point) {
    return point ? with_place(glm::vec4{*point, 1.0F}) : std::nullopt;
}

} // namespace

SpaceMap::SpaceMap(const trace::Recording& recording, const SpaceView& view, std::uint32_t object)
    : call_(&recording.frame->calls()[object]), space_(view.space), morph_(view.morph) {
    const scene::Settings& settings = recording.settings();
    directions_ = {
        .forward = scene::forward_sign(recording.scene().camera),
        .ndc_grows_with_distance = settings.depth_convention != scene::DepthConvention::reversed};
    const pipeline::Transforms& t = call_->vertex.transforms;
    if (space_ == Space::world) {
        from_eye_ = glm::inverse(t.view.matrix);
    } else if (space_ == Space::object) {
        from_eye_ = glm::inverse(t.view.matrix * t.model.matrix);
    }
}

std::optional<glm::vec3> SpaceMap::of_vertex(std::uint32_t vertex) const {
    const glm::vec4& position = call_->vertex.mesh->positions[vertex];
    const pipeline::Transforms& t = call_->vertex.transforms;
    if (space_ == Space::object) {
        return with_place(position);
    }
    const glm::vec4 world = t.model.matrix * position;
    if (space_ == Space::world) {
        return with_place(world);
    }
    const glm::vec4 clip = math::to_vec4(call_->vertices[vertex].clip);
    return checked(explain::morphed(t.view.matrix * world, clip, directions_, morph_));
}

std::optional<glm::vec3> SpaceMap::of_eye(const glm::vec3& point) const {
    const glm::vec4 eye{point, 1.0F};
    if (space_ == Space::object || space_ == Space::world) {
        return with_place(from_eye_ * eye);
    }
    const glm::vec4 clip = call_->vertex.transforms.projection.matrix * eye;
    return checked(explain::morphed(eye, clip, directions_, morph_));
}

std::array<glm::vec3, 4> ViewVolume::section(float distance) const {
    const float part = (distance - near_distance) / (far_distance - near_distance);
    std::array<glm::vec3, 4> corners{};
    for (unsigned i = 0; i < 4; ++i) {
        corners[i] = near[i] + (far[i] - near[i]) * part;
    }
    return corners;
}

std::optional<ViewVolume> view_volume(const trace::Recording& recording) {
    if (recording.frame->calls().empty()) {
        return std::nullopt;
    }
    // In double: the far plane may be a million times as far away as the near plane
    const glm::dmat4 projection{
        recording.frame->calls().front().vertex.transforms.projection.matrix};
    const scene::DepthConvention convention = recording.settings().depth_convention;
    const bool reversed = convention == scene::DepthConvention::reversed;
    const double near_z = convention == scene::DepthConvention::opengl ? -1.0
                          : reversed                                   ? 1.0
                                                                       : 0.0;
    const double far_z = reversed ? 0.0 : 1.0;
    if (glm::determinant(projection) == 0.0) {
        return std::nullopt;
    }
    const glm::dmat4 back = glm::inverse(projection);
    constexpr std::array<glm::dvec2, 4> square{
        {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}};
    ViewVolume volume;
    for (unsigned i = 0; i < 4; ++i) {
        const glm::dvec4 near = back * glm::dvec4{square[i], near_z, 1.0};
        const glm::dvec4 far = back * glm::dvec4{square[i], far_z, 1.0};
        volume.near[i] = glm::vec3{glm::dvec3{near} / near.w};
        volume.far[i] = glm::vec3{glm::dvec3{far} / far.w};
    }
    const scene::Camera& camera = recording.scene().camera;
    const float forward = scene::forward_sign(camera);
    volume.near_distance = forward * volume.near[0].z;
    volume.far_distance = forward * volume.far[0].z;
    volume.has_eye = camera.projection.kind == scene::ProjectionKind::perspective ||
                     camera.projection.kind == scene::ProjectionKind::frustum;
    return volume.near_distance < volume.far_distance ? std::optional{volume} : std::nullopt;
}

} // namespace hs::viewer
