// The lines of the space view: edges of the meshes in one coordinate space, thinned out where there
// are too many, placed and projected only when something about the view has changed.
#pragma once

#include "app/viewer/document.hpp"
#include "app/viewer/orbit_camera.hpp"
#include "app/viewer/space_map.hpp"
#include "app/viewer/state.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <vector>

namespace hs::viewer {

class SpaceLines {
public:
    using Segment = std::array<ImVec2, 2>;

    /// Brings the lines up to date. Precondition: a document is open.
    void update(const Document& document, const SpaceView& view);

    [[nodiscard]] const std::vector<Segment>& edges() const { return projected_; }
    [[nodiscard]] const OrbitCamera& camera() const { return camera_; }
    [[nodiscard]] std::size_t all_edges() const { return all_edges_; }
    [[nodiscard]] float radius() const { return framing_.radius; }
    /// Empty where there is none to draw.
    [[nodiscard]] const std::optional<ViewVolume>& volume() const { return volume_; }
    /// The distance from the eye up to which the view volume is of interest: just behind the
    /// meshes, or its far plane.
    [[nodiscard]] float interest() const { return interest_; }

private:
    /// What the lines are made of; when it differs, they are placed anew.
    struct Subject {
        unsigned document = 0;
        Space space = Space::world;
        float morph = 0.0F;       ///< of eye, clip and NDC
        std::uint32_t object = 0; ///< in object space, the one shown
        std::optional<std::uint32_t>
            planes; ///< the triangle whose planes through the eye are shown
        friend bool operator==(const Subject&, const Subject&) = default;
    };

    class Bounds;

    void meet(const Document& document);
    void collect(const Document& document, const SpaceView& view);
    [[nodiscard]] Framing framing_of(const Document& document, const SpaceView& view) const;
    [[nodiscard]] std::optional<Framing>
    framing_of_planes(const Document& document, const SpaceView& view) const;
    [[nodiscard]] Framing framing_on_the_way(const Document& document, const SpaceView& view) const;
    void add_volume(Bounds& bounds, const SpaceMap& map, float divided) const;

    std::optional<Subject> subject_;
    std::optional<ViewVolume> volume_;
    float interest_ = 1.0F;
    std::vector<std::array<glm::vec3, 2>> lines_;
    std::size_t all_edges_ = 0;
    Framing framing_;
    std::optional<SpaceView> view_; ///< what `projected_` was made for
    OrbitCamera camera_;
    std::vector<Segment> projected_;
};

} // namespace hs::viewer
