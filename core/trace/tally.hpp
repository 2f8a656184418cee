// Counting what happens. Recording, re-runs and the playhead count with the same lines, so their
// numbers cannot part.
#pragma once

#include "core/trace/recording.hpp"
#include "core/trace/step.hpp"

namespace hs::trace {

/// `passed` is false for the test that a fragment ends with; `first` marks the first clip pass of a
/// triangle and the first test of a fragment.
inline void count_step(Counters& counters, StepKind kind, bool passed, bool first) {
    switch (kind) {
    case StepKind::start:
    case StepKind::resolve:
    case StepKind::end:
    case StepKind::order: // counted by kind of decision
    case StepKind::sweep: // likewise
    case StepKind::vertex_eye:
    case StepKind::vertex_clip:
    case StepKind::vertex_light: break;
    case StepKind::vertex_world: ++counters.vertices; break;
    case StepKind::outcodes: ++counters.triangles; break;
    case StepKind::clip_plane: counters.clipped += first ? 1U : 0U; break;
    case StepKind::divide: ++counters.pieces; break;
    case StepKind::viewport: ++counters.pieces_mapped; break;
    case StepKind::facing: ++counters.pieces_faced; break;
    case StepKind::setup: ++counters.pieces_set_up; break;
    case StepKind::edge_table:
    case StepKind::active_edges:
    case StepKind::span: ++counters.scan_steps; break;
    case StepKind::tile_test:
    case StepKind::edge_test:
    case StepKind::sample_test:
    case StepKind::plane_test:
    case StepKind::line_step: break; // tiles and pixels are part of the cost
    case StepKind::interpolate: ++counters.fragments; break;
    case StepKind::shade: ++counters.fragments_shaded; break;
    case StepKind::scissor_test:
    case StepKind::closed_test:
    case StepKind::depth_test: {
        counters.fragments_tested += first ? 1U : 0U;
        const auto failed = kind == StepKind::depth_test ? fragment::FragmentFate::depth_failed
                            : kind == StepKind::closed_test
                                ? fragment::FragmentFate::pixel_closed
                                : fragment::FragmentFate::scissor_failed;
        counters.fates[static_cast<std::size_t>(failed)] += passed ? 0U : 1U;
        break;
    }
    case StepKind::merge:
        ++counters.fates[static_cast<std::size_t>(fragment::FragmentFate::written)];
        break;
    }
}

/// What a traversal spent belongs to the next step.
inline void count_cost(Counters& counters, const raster::Cost& cost) {
    counters.traversal += cost;
}

} // namespace hs::trace
