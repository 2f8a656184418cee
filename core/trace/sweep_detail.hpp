// The reasoning behind a row of the image that is drawn as a whole: the state of its scanline or
// ray at a step, obtained by running the row, or the ray, again.
#pragma once

#include "core/pipeline/sweep.hpp"
#include "core/trace/recording.hpp"

#include <optional>
#include <vector>

namespace hs::trace {

struct SweepDetail {
    int row = 0;
    PixelPos pixel; ///< the ray's
    /// The decisions of the row, or of the ray, up to the step; at least one.
    std::vector<visibility::SweepEvent> decisions;
    std::optional<visibility::ScanState> scan; ///< after the last of them; scanlines
    std::optional<visibility::LineBuffer>
        line;                               ///< likewise; a line of depths, from its clearing on
    std::optional<visibility::RayCast> ray; ///< likewise; rays

    [[nodiscard]] const visibility::SweepEvent& last() const { return decisions.back(); }
};

/// Costs a run of the row, or of one ray. Precondition: recording.in_row(step.id).
SweepDetail sweep_detail(const Recording& recording, const Step& step);

} // namespace hs::trace
