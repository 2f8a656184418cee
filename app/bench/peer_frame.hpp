// The peer's half of a comparison: the same mesh, camera and light drawn by OSMesa.
#pragma once

#include "app/bench/workload.hpp"
#include "app/peer/timed_mesh.hpp"
#include "core/framebuffer/framebuffer.hpp"

#include <optional>

namespace hs::bench {

class PeerFrame {
public:
    /// Empty where Mesa cannot draw this size.
    [[nodiscard]] static std::optional<PeerFrame>
    create(const peer::Context& mesa, const Subject& subject, const scene::Scene& scene);

    /// Milliseconds from clearing to the last pixel.
    double draw() { return mesh_.draw_frame(settings_); }

    /// Covered pixels, and pixels that only one of the two pictures covers. Both transform with
    /// their own rounding, so that now and then a vertex snaps differently: one pixel in ten
    /// thousand may differ.
    struct Agreement {
        std::size_t covered = 0;
        std::size_t differing = 0;

        [[nodiscard]] bool same_picture() const { return differing * 10'000 <= covered; }
    };
    /// Holds the last frame against ours of the same scene.
    [[nodiscard]] Agreement compare(const framebuffer::Framebuffer& ours) const;

private:
    PeerFrame(peer::TimedMesh mesh, const peer::FrameSettings& settings)
        : mesh_(std::move(mesh)), settings_(settings) {}

    peer::TimedMesh mesh_;
    peer::FrameSettings settings_;
};

} // namespace hs::bench
