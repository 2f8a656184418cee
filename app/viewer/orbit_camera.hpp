// The space view's own camera: it sees the spaces from outside, either circling around them or
// exactly from the side, where distance runs to the right and y up.
#pragma once

#include "app/viewer/state.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <optional>

namespace hs::viewer {

/// What the camera is to hold in the picture.
struct Framing {
    glm::vec3 low{-1.0F};
    glm::vec3 high{1.0F};
    float radius = 1.0F; ///< of the content around the box's middle

    [[nodiscard]] glm::vec3 middle() const { return (low + high) * 0.5F; }
};

class OrbitCamera {
public:
    OrbitCamera() = default;
    OrbitCamera(const SpaceView& view, const Framing& framing);

    /// Window position; empty behind the camera.
    [[nodiscard]] std::optional<ImVec2> project(const glm::vec3& point) const;
    /// A segment's visible part; empty when all of it is behind the camera.
    [[nodiscard]] std::optional<std::array<ImVec2, 2>>
    project(const glm::vec3& a, const glm::vec3& b) const;

private:
    [[nodiscard]] glm::vec3 turn(const glm::vec3& point) const;
    [[nodiscard]] ImVec2 to_window(const glm::vec3& turned) const;

    bool side_ = false;
    glm::vec3 middle_{0.0F};
    float scale_ = 1.0F;
    float sin_yaw_ = 0.0F, cos_yaw_ = 1.0F, sin_pitch_ = 0.0F, cos_pitch_ = 1.0F;
    float distance_ = 3.0F;
    ImVec2 window_middle_;
    float pixels_ = 100.0F;
};

} // namespace hs::viewer
