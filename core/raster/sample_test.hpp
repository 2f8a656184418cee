// The question asked at a sample.
#pragma once

#include "core/base/pixel.hpp"
#include "core/raster/edge_function.hpp"

namespace hs::raster {

/// Where a sample lies relative to the three edges, as told by a traversal.
struct SampleTest {
    PixelPos pixel;
    int sample = 0;
    EdgeValues edges{}; ///< E01, E12, E20 at the sample
    bool inside = false;
};

} // namespace hs::raster
