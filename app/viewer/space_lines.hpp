// The lines of the space view: edges of the meshes in one coordinate space, thinned out where there
// are too many, projected only when something about the view has changed.
#pragma once

#include "app/viewer/document.hpp"
#include "app/viewer/state.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <vector>

namespace hs::viewer {

/// The outside camera: orbits around what is shown.
class OrbitCamera {
public:
    OrbitCamera() = default;
    OrbitCamera(const SpaceView& view, const glm::vec3& center, float radius);

    /// Window position; empty behind the camera.
    [[nodiscard]] std::optional<ImVec2> project(const glm::vec3& point) const;
    /// A segment's visible part; empty when all of it is behind the camera.
    [[nodiscard]] std::optional<std::array<ImVec2, 2>>
    project(const glm::vec3& a, const glm::vec3& b) const;

private:
    [[nodiscard]] glm::vec3 turn(const glm::vec3& point) const;
    [[nodiscard]] ImVec2 to_window(const glm::vec3& turned) const;

    glm::vec3 center_{0.0F};
    float scale_ = 1.0F;
    float sin_yaw_ = 0.0F, cos_yaw_ = 1.0F, sin_pitch_ = 0.0F, cos_pitch_ = 1.0F;
    float distance_ = 3.0F;
    ImVec2 middle_;
    float pixels_ = 100.0F;
};

class SpaceLines {
public:
    using Segment = std::array<ImVec2, 2>;

    /// Brings the lines up to date. Precondition: a document is open.
    void update(const Document& document, const SpaceView& view);

    [[nodiscard]] const std::vector<Segment>& edges() const { return projected_; }
    [[nodiscard]] const OrbitCamera& camera() const { return camera_; }
    [[nodiscard]] std::size_t all_edges() const { return all_edges_; }
    [[nodiscard]] float radius() const { return radius_; }

private:
    struct Subject {
        unsigned document = 0;
        Space space = Space::world;
        std::uint32_t object = 0; ///< in object space, the one shown
        friend bool operator==(const Subject&, const Subject&) = default;
    };

    void collect(const Document& document);
    void measure(const Document& document);

    std::optional<Subject> subject_;
    std::vector<std::array<glm::vec3, 2>> lines_;
    std::size_t all_edges_ = 0;
    glm::vec3 center_{0.0F};
    float radius_ = 1.0F;
    std::optional<SpaceView> view_; ///< what `projected_` was made for
    OrbitCamera camera_;
    std::vector<Segment> projected_;
};

/// A vertex in a space; empty where it has no place (w <= 0 after the divide).
std::optional<glm::vec3> vertex_in_space(
    const trace::Recording& recording, Space space, std::uint32_t object, std::uint32_t vertex
);

/// The view volume's corners in a space: near plane first, counterclockwise from bottom left.
/// Empty where the volume has no corners there.
std::optional<std::array<glm::vec3, 8>>
view_volume(const trace::Recording& recording, Space space, std::uint32_t object);

} // namespace hs::viewer
