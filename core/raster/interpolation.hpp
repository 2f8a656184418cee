// From edge values to a fragment: barycentric weights, depth, perspective-correct varyings.
//
// Barycentric weights as areas: λ0 = E12 / 2A, λ1 = E20 / 2A, λ2 = E01 / 2A. Depth is linear in the
// window. Varyings are linear in eye space: Heckbert and Moreton, Interpolation for Polygon Texture
// Mapping and Shading, 1991 (v/w and 1/w are linear in the window). Differs: weights are corrected
// once, b_i = λ_i (1/w_i) / Σ λ_j (1/w_j), and every varying is then interpolated in difference
// form.
#pragma once

#include "core/base/pixel.hpp"
#include "core/math/interpolate.hpp"
#include "core/math/reciprocal.hpp"
#include "core/math/varyings.hpp"
#include "core/raster/triangle_setup.hpp"
#include "core/scene/settings.hpp"

#include <array>

namespace hs::raster {

/// What is interpolated over one triangle: depth, 1/w and varyings at its three vertices.
struct Interpolants {
    float depth0 = 0.0F, depth1 = 0.0F, depth2 = 0.0F; ///< window depth at the vertices
    float inv_w0 = 1.0F, inv_w1 = 1.0F, inv_w2 = 1.0F;
    const float* varyings0 = nullptr; ///< the vertices', not owned, `varying_count` floats each
    const float* varyings1 = nullptr;
    const float* varyings2 = nullptr;
    int varying_count = 4;
    bool perspective = true;
};

/// A candidate for a pixel.
struct Fragment {
    PixelPos pixel;
    std::array<float, 3> barycentric{};      ///< λ0, λ1, λ2 in the window
    std::array<float, 3> barycentric_clip{}; ///< b0, b1, b2 after the perspective correction
    float depth = 0.0F;                      ///< window depth before the format rounds it
    math::Varyings varyings;
};

/// A pure function of setup and pixel: no accumulation, so every traversal gives the same bits.
[[nodiscard]] inline Fragment interpolate(
    const Interpolants& in, const TriangleSetup& setup, PixelPos pixel, const EdgeValues& e
) {
    Fragment f;
    f.pixel = pixel;

    // Weights in the window: areas of the three sub-triangles over the whole
    const float lambda1 = static_cast<float>(e[2]) * setup.inv_doubled_area;
    const float lambda2 = static_cast<float>(e[0]) * setup.inv_doubled_area;
    f.barycentric = {1.0F - lambda1 - lambda2, lambda1, lambda2};

    // Depth is linear in the window
    f.depth = math::interpolate(in.depth0, in.depth1, in.depth2, lambda1, lambda2);

    // Correct the weights for perspective: divide by the interpolated 1/w
    float b1 = lambda1;
    float b2 = lambda2;
    if (in.perspective) {
        const float inv_w = math::interpolate(in.inv_w0, in.inv_w1, in.inv_w2, lambda1, lambda2);
        const float w = math::reciprocal(inv_w); // 0 only without clipping, between w > 0 and w < 0
        b1 = lambda1 * in.inv_w1 * w;
        b2 = lambda2 * in.inv_w2 * w;
    }
    f.barycentric_clip = {1.0F - b1 - b2, b1, b2};

    // Interpolate what the shading uses
    for (int i = 0; i < in.varying_count; ++i) {
        f.varyings[i] =
            math::interpolate(in.varyings0[i], in.varyings1[i], in.varyings2[i], b1, b2);
    }
    return f;
}

} // namespace hs::raster
