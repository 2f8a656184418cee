// What homogeneous rasterization asks of a pixel.
#pragma once

#include <array>

namespace hs::raster {

struct PlaneTest {
    std::array<double, 3> edges{}; ///< E01, E12, E20: b_i / w of the vertex opposite
    double inv_w = 0.0;            ///< their sum: > 0 in front of the eye
    std::array<double, 4> clips{}; ///< distance over w of the clip planes that are still to test
    bool inside = false;
};

} // namespace hs::raster
