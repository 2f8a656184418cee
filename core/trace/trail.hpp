// The trail of a traversal: everything it asked of the current piece up to a step, for pictures of
// its path, its tiles and its spans.
#pragma once

#include "core/raster/sample_pattern.hpp"
#include "core/raster/scan_edge.hpp"
#include "core/raster/tile.hpp"
#include "core/trace/recording.hpp"
#include "core/trace/step.hpp"

#include <cstddef>
#include <vector>

namespace hs::trace {

/// A pixel the traversal came to: asked, or known to be covered.
struct TrailVisit {
    PixelPos pixel;
    bool covered = false;             ///< with several samples: one of those asked is
    int samples_asked = 0;            ///< with several samples: in order, up to the step
    raster::CoverageMask samples = 0; ///< those found covered, asked or not
};

/// In the order things happened.
struct Trail {
    std::vector<TrailVisit> visits;
    std::vector<raster::TileTest> tiles;
    std::vector<raster::Span> spans;
    bool whole = true; ///< from the traversal's beginning; else from the step's unit on
};

/// Up to and including `step`; empty where the step is in no traversal. A piece whose bounding box
/// (with brute force: whose image) has more than `most_pixels` is followed in the step's unit only.
Trail trail(const Recording& recording, const Step& step, std::size_t most_pixels = 16384);

} // namespace hs::trace
