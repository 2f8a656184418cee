// A fresh run of a frame that writes down its state at every step: what a playhead must show,
// whichever way it arrived.
#pragma once

#include "core/framebuffer/framebuffer.hpp"
#include "core/scene/scene.hpp"
#include "core/trace/player.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace hs::tests {

/// State after one step.
struct Moment {
    trace::StepKind kind = trace::StepKind::start;
    std::uint64_t framebuffer = 0; ///< digest of color and depth
    trace::Counters counters;
};

/// One moment per step, from `start` to `end`. Uses its own counting, not the recorder's.
std::vector<Moment> fresh_run(const std::shared_ptr<const scene::Scene>& scene);

/// Digest of what a player shows, comparable with Framebuffer::digest().
std::uint64_t shown_digest(const trace::Player& player);

} // namespace hs::tests
