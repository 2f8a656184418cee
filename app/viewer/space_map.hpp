// Where the space view draws points: in one of the spaces, or on the way from eye space to NDC.
#pragma once

#include "app/viewer/state.hpp"
#include "core/explain/space_morph.hpp"
#include "core/trace/recording.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <optional>

namespace hs::viewer {

class SpaceMap {
public:
    /// Precondition: the frame has objects. `object` matters in object space, and for its matrices.
    SpaceMap(const trace::Recording& recording, const SpaceView& view, std::uint32_t object);

    /// Empty where the point has no place: behind the eye after the divide.
    [[nodiscard]] std::optional<glm::vec3> of_vertex(std::uint32_t vertex) const;
    /// Of a point of eye space.
    [[nodiscard]] std::optional<glm::vec3> of_eye(const glm::vec3& point) const;

private:
    const pipeline::DrawCall* call_;
    Space space_;
    float morph_;
    explain::DepthDirections directions_;
    glm::mat4 from_eye_{1.0F}; ///< to world or object space
};

/// The view volume in eye space. Its edges from the near to the far plane are straight in every
/// space.
struct ViewVolume {
    std::array<glm::vec3, 4> near{}; ///< counterclockwise from bottom left, as seen from the eye
    std::array<glm::vec3, 4> far{};
    float near_distance = 0.0F; ///< along the line of sight
    float far_distance = 1.0F;
    bool has_eye = false; ///< the edges meet in the eye

    /// The corners of its section at a distance.
    [[nodiscard]] std::array<glm::vec3, 4> section(float distance) const;
};

/// Empty for a projection that cannot be undone.
std::optional<ViewVolume> view_volume(const trace::Recording& recording);

} // namespace hs::viewer
