// What every visible-surface algorithm makes of the same scene: each is recorded, and its picture
// held against the z-buffer's.
#pragma once

#include "core/trace/recording.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hs::trace {

/// Where two frames of the same size show different triangles.
struct OwnerDifference {
    std::uint64_t pixels = 0;
    std::optional<PixelPos> first; ///< row by row from the top
};
OwnerDifference difference_of_owners(const Recording& a, const Recording& b);

struct VisibilityOutcome {
    scene::Visibility visibility = scene::Visibility::none;
    std::string refusal; ///< why it cannot draw this scene; then nothing else is known
    OrderCounts decisions{};
    SweepCounts sweeps{};
    std::uint64_t decision_count = 0;
    std::uint64_t questions = 0; ///< of those, where two things were held against each other: keys,
                                 ///< polygons and planes, depths, a ray and a triangle; depth tests
    std::uint64_t cuts = 0;
    std::uint64_t parts = 0; ///< triangles made by cutting
    std::uint64_t fragments = 0;
    std::uint64_t written = 0;
    OwnerDifference from_z_buffer{};
    std::uint32_t shown = no_triangle;   ///< at the first differing pixel, over the whole frame
    std::uint32_t nearest = no_triangle; ///< the z-buffer's there
};

/// In the order of the enumeration.
std::vector<VisibilityOutcome> compare_visibility(const scene::Scene& scene);

} // namespace hs::trace
