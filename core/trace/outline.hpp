// Outlines: all steps between two neighbouring entries of a recording's index, found by running
// that stretch again.
//
// This is how a flat step number becomes an address without storing an address per step: about two
// thousand steps (or one unit, if it is longer) are re-run, which takes well under a millisecond
// however large the trace is.
#pragma once

#include "core/trace/recording.hpp"
#include "core/trace/step.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hs::trace {

struct Outline {
    StepId first_step = 0;
    std::vector<Step> steps;         ///< consecutive: steps[i].id = first_step + i
    std::vector<raster::Cost> costs; ///< what the traversal spent from the step before to this one
    /// Fragments whose re-run differed from the log. Always 0 unless program or recording are
    /// damaged.
    std::uint32_t divergences = 0;
};

/// The index entry whose stretch contains a step of the triangle stages.
/// Precondition: first_triangle_step <= step < first_resolve_step.
std::size_t index_entry_of_step(const Recording& recording, StepId step);

/// Re-runs the stretch from index entry `entry` to the next one.
Outline outline(const Recording& recording, std::size_t entry);

} // namespace hs::trace
