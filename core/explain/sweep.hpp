// The decisions of scanlines and rays in words and formulas.
#pragma once

#include "core/explain/formulas.hpp"
#include "core/trace/recording.hpp"
#include "core/trace/sweep_detail.hpp"

#include <string>
#include <vector>

namespace hs::explain {

/// What a polygon of a sweep is called: "triangle 3", "piece 1 of triangle 3 of object 0".
std::string swept_name(const trace::Recording& recording, std::int32_t polygon);
/// Its numbers alone, as `polygon_label`.
std::string swept_label(const trace::Recording& recording, std::int32_t polygon);
/// "AC": letters for corners from the upper to the lower end, while the alphabet lasts; then the
/// polygon's label and the numbers of the corners.
std::string edge_label(
    const trace::Recording& recording, const visibility::ScanScene& scene, std::int32_t edge
);

/// About the last decision of a detail.
std::string sweep_sentence(const trace::Recording& recording, const trace::SweepDetail& detail);

/// How its numbers came about.
std::vector<Formula>
sweep_formulas(const trace::Recording& recording, const trace::SweepDetail& detail);

} // namespace hs::explain
