// Random small scenes that reach every branch of the pipeline: vertices behind the eye, degenerate
// and huge triangles, several objects with settings of their own, every format, test and order.
#pragma once

#include "core/scene/scene.hpp"

#include <cstdint>
#include <memory>

namespace hs::tests {

/// The same scene for the same seed, on every compiler: no distribution of the standard library is
/// used.
std::shared_ptr<const scene::Scene> random_scene(std::uint64_t seed);

/// The same scene, its pixels asked at several samples or as whole squares.
std::shared_ptr<const scene::Scene> sampled_scene(std::uint64_t seed);

/// Small, portable, seeded: SplitMix64 (Steele, Lea and Flood, 2014).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31U);
    }
    /// In [0, count).
    std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(next() % count); }
    /// In [low, high).
    float between(float low, float high) {
        const float unit = static_cast<float>(next() >> 40U) * 0x1p-24F;
        return low + unit * (high - low);
    }
    bool one_in(std::uint32_t count) { return below(count) == 0; }

private:
    std::uint64_t state_;
};

} // namespace hs::tests
