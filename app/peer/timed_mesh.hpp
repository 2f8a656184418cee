// The frame that `halfspace bench` measures Mesa with: z-buffer, back faces culled, Gouraud
// shading.
#pragma once

#include "osmesa.hpp"

#include <glm/mat4x4.hpp>

namespace hs::peer {

/// Triangles index both arrays, which have the same length.
struct MeshView {
    std::span<const glm::vec3> positions = {};
    /// Of unit length, in object space like the positions.
    std::span<const glm::vec3> normals = {};
    std::span<const glm::uvec3> triangles = {};
};

struct FrameSettings {
    /// Column vectors, y up, −w ≤ z ≤ w.
    glm::mat4 clip_from_object{1.0F};
    /// Unit vector towards the light, in object space.
    glm::vec3 to_light = {0.0F, 0.0F, 1.0F};
    /// A vertex has color × (ambient + (1 − ambient) · max(0, normal · to_light)), and alpha 1.
    glm::vec3 color = {1.0F, 1.0F, 1.0F};
    float ambient = 0.2F;
    /// Front faces as seen in the picture.
    Winding front = Winding::ccw;
};

class TimedMesh {
public:
    /// Uploads the mesh for pictures of width × height pixels (1 … 16384) in RGBA8 with 24-bit
    /// depth. Empty, and a sentence in `why_not` unless that is null, for an impossible size or
    /// index. The mesh keeps what it needs of the context alive.
    [[nodiscard]] static std::optional<TimedMesh> create(
        const Context& context,
        const MeshView& mesh,
        int width,
        int height,
        std::string* why_not = nullptr
    );

    TimedMesh(const TimedMesh&) = delete;
    TimedMesh& operator=(const TimedMesh&) = delete;
    TimedMesh(TimedMesh&&) noexcept;
    TimedMesh& operator=(TimedMesh&&) noexcept;
    ~TimedMesh();

    /// Draws one frame and returns its milliseconds: from clearing color and depth to the end of
    /// glFinish; neither uploading nor reading back. The first frame also compiles Mesa's shaders:
    /// do not count it.
    double draw_frame(const FrameSettings& settings);

    /// The last frame, top row first, without triangle ids.
    [[nodiscard]] Image image() const;

private:
    struct State;

    explicit TimedMesh(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

} // namespace hs::peer
