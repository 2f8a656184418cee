// Recordings for the tests of exports, which write what a player shows.
#pragma once

#include "core/scene/scene.hpp"
#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

#include <memory>

namespace hs::tests {

inline std::shared_ptr<const trace::Recording> recorded(std::shared_ptr<const scene::Scene> scene) {
    auto recording = trace::record(std::move(scene));
    REQUIRE(recording);
    return *recording;
}

/// Players in the middle of random frames: every format, clipped and hidden triangles, several
/// objects; every other one with several samples a pixel, or conservative.
inline trace::Player random_player(std::uint64_t seed) {
    trace::Player player(recorded(seed % 2 == 0 ? random_scene(seed) : sampled_scene(seed)));
    Random random(seed + 1000);
    player.seek(random.next() % (player.end() + 1));
    return player;
}

inline constexpr std::uint64_t random_frames = 40;

} // namespace hs::tests
