// How the work of every visible-surface algorithm grows with the number of polygons: the same scene
// is tried with fewer of them.
//
// The comparison of Sutherland, Sproull and Schumacker, A Characterization of Ten Hidden-Surface
// Algorithms, 1974, measured instead of estimated.
#pragma once

#include "core/trace/visibility_comparison.hpp"

#include <cstddef>
#include <vector>

namespace hs::trace {

struct GrowthPoint {
    std::size_t triangles = 0;
    std::vector<VisibilityOutcome> outcomes; ///< in the order of the enumeration
};

/// Halves the polygons of every mesh from point to point, evenly over the file; fewest first, the
/// whole scene last. Polygons keep their size: half of them cover half as much.
std::vector<GrowthPoint> visibility_growth(const scene::Scene& scene, int points = 5);

/// The scene with `part` of `whole` of its polygons, lines and points left out.
scene::Scene thinned(const scene::Scene& scene, std::size_t part, std::size_t whole);

} // namespace hs::trace
