#include "app/viewer/orbit_camera.hpp"

#include <algorithm>
#include <cmath>

namespace hs::viewer {
namespace {

constexpr float nearest = 0.05F;      ///< lines are cut this far before the camera
constexpr float base_distance = 3.2F; ///< in radii of the content
constexpr float filled = 0.94F;       ///< of the panel by the content

} // namespace

OrbitCamera::OrbitCamera(const SpaceView& view, const Framing& framing)
    : side_(view.side),
      middle_(framing.middle()),
      scale_(1.0F / framing.radius),
      sin_yaw_(std::sin(view.yaw)),
      cos_yaw_(std::cos(view.yaw)),
      sin_pitch_(std::sin(view.pitch)),
      cos_pitch_(std::cos(view.pitch)),
      distance_(base_distance * view.distance),
      window_middle_{view.area.x + view.area.width * 0.5F, view.area.y + view.area.height * 0.5F} {
    if (side_) {
        const glm::vec3 size = framing.high - framing.low;
        constexpr float least = 1.0e-6F;
        const float fit = std::min(
            view.area.width / std::max(least, size.z), view.area.height / std::max(least, size.y)
        );
        pixels_ = fit * filled / (scale_ * view.distance);
        return;
    }
    // A sphere of radius 1 at this distance reaches 1/√(d² − 1) off the middle
    const float reach = 1.0F / std::sqrt(base_distance * base_distance - 1.0F);
    pixels_ = std::min(view.area.width, view.area.height) * 0.5F * filled / reach;
}

glm::vec3 OrbitCamera::turn(const glm::vec3& point) const {
    const glm::vec3 p = (point - middle_) * scale_;
    if (side_) {
        return {-p.z, p.y, 1.0F};
    }
    const float x = cos_yaw_ * p.x - sin_yaw_ * p.z;
    const float z = sin_yaw_ * p.x + cos_yaw_ * p.z;
    return {x, cos_pitch_ * p.y - sin_pitch_ * z, distance_ - (sin_pitch_ * p.y + cos_pitch_ * z)};
}

ImVec2 OrbitCamera::to_window(const glm::vec3& turned) const {
    return {
        window_middle_.x + pixels_ * turned.x / turned.z,
        window_middle_.y - pixels_ * turned.y / turned.z};
}

std::optional<ImVec2> OrbitCamera::project(const glm::vec3& point) const {
    const glm::vec3 turned = turn(point);
    return turned.z > nearest ? std::optional{to_window(turned)} : std::nullopt;
}

std::optional<std::array<ImVec2, 2>>
OrbitCamera::project(const glm::vec3& a, const glm::vec3& b) const {
    glm::vec3 from = turn(a);
    glm::vec3 to = turn(b);
    if (from.z <= nearest && to.z <= nearest) {
        return std::nullopt;
    }
    if (from.z <= nearest) {
        from += (to - from) * ((nearest - from.z) / (to.z - from.z));
    } else if (to.z <= nearest) {
        to += (from - to) * ((nearest - to.z) / (from.z - to.z));
    }
    return std::array{to_window(from), to_window(to)};
}

} // namespace hs::viewer
