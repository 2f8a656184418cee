// From edge values to a fragment: barycentric weights, depth, perspective-correct varyings.
//
// Barycentric weights as areas: λ0 = E12 / 2A, λ1 = E20 / 2A, λ2 = E01 / 2A. Depth is linear in the
// window. Varyings are linear in eye space: Heckbert and Moreton, Interpolation for Polygon Texture
// Mapping and Shading, 1991 (v/w and 1/w are linear in the window). Differs: weights are corrected
// once, b_i = λ_i (1/w_i) / Σ λ_j (1/w_j), and every varying is then interpolated in difference
// form, whose differences are taken once per triangle.
#pragma once

#include "core/base/pixel.hpp"
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

/// The same in difference form: v0, v1 − v0 and v2 − v0 of everything interpolated.
class Interpolator {
public:
    explicit Interpolator(const Interpolants& in)
        : depth_{in.depth0, in.depth1 - in.depth0, in.depth2 - in.depth0},
          inv_w_{in.inv_w0, in.inv_w1 - in.inv_w0, in.inv_w2 - in.inv_w0},
          inv_w1_(in.inv_w1),
          inv_w2_(in.inv_w2),
          count_(in.varying_count),
          perspective_(in.perspective) {
        for (unsigned i = 0; i < static_cast<unsigned>(count_); ++i) {
            values_[i] = in.varyings0[i];
            differences1_[i] = in.varyings1[i] - in.varyings0[i];
            differences2_[i] = in.varyings2[i] - in.varyings0[i];
        }
    }

    [[nodiscard]] float depth(float lambda1, float lambda2) const {
        return at(depth_, lambda1, lambda2);
    }
    [[nodiscard]] float inv_w(float lambda1, float lambda2) const {
        return at(inv_w_, lambda1, lambda2);
    }
    [[nodiscard]] float inv_w1() const { return inv_w1_; }
    [[nodiscard]] float inv_w2() const { return inv_w2_; }
    [[nodiscard]] bool perspective() const { return perspective_; }

    void varyings(float b1, float b2, math::Varyings& out) const {
        constexpr unsigned color = 4; // always there: a fixed number of turns, so four at a time
        for (unsigned i = 0; i < color; ++i) {
            out.values[i] = values_[i] + b1 * differences1_[i] + b2 * differences2_[i];
        }
        for (unsigned i = color; i < static_cast<unsigned>(count_); ++i) {
            out.values[i] = values_[i] + b1 * differences1_[i] + b2 * differences2_[i];
        }
    }

private:
    using Differences = std::array<float, 3>;
    [[nodiscard]] static float at(const Differences& v, float lambda1, float lambda2) {
        return v[0] + lambda1 * v[1] + lambda2 * v[2];
    }

    Differences depth_;
    Differences inv_w_;
    float inv_w1_;
    float inv_w2_;
    int count_;
    bool perspective_;
    std::array<float, math::max_varyings> values_{};
    std::array<float, math::max_varyings> differences1_{};
    std::array<float, math::max_varyings> differences2_{};
};

/// A candidate for a pixel.
struct Fragment {
    PixelPos pixel;
    std::array<float, 3> barycentric{};      ///< λ0, λ1, λ2 in the window
    std::array<float, 3> barycentric_clip{}; ///< b0, b1, b2 after the perspective correction
    float depth = 0.0F;                      ///< window depth before the format rounds it
    math::Varyings varyings;
};

/// The part of a fragment that its tests need: weights in the window, and depth. A pure function of
/// setup and pixel: no accumulation, so every traversal gives the same bits.
[[nodiscard]] inline Fragment place_fragment(
    const Interpolator& in, const TriangleSetup& setup, PixelPos pixel, const EdgeValues& e
) {
    Fragment f;
    f.pixel = pixel;

    // Weights in the window: areas of the three sub-triangles over the whole
    const float lambda1 = static_cast<float>(e[2]) * setup.inv_doubled_area;
    const float lambda2 = static_cast<float>(e[0]) * setup.inv_doubled_area;
    f.barycentric = {1.0F - lambda1 - lambda2, lambda1, lambda2};

    // Depth is linear in the window
    f.depth = in.depth(lambda1, lambda2);
    return f;
}

/// The part that its shading needs.
inline void interpolate_varyings(const Interpolator& in, Fragment& f) {
    // Correct the weights for perspective: divide by the interpolated 1/w
    float b1 = f.barycentric[1];
    float b2 = f.barycentric[2];
    if (in.perspective()) {
        // 1/w is 0 only without clipping, between w > 0 and w < 0
        const float w = math::reciprocal(in.inv_w(b1, b2));
        b1 = b1 * in.inv_w1() * w;
        b2 = b2 * in.inv_w2() * w;
    }
    f.barycentric_clip = {1.0F - b1 - b2, b1, b2};
    in.varyings(b1, b2, f.varyings);
}

/// All of a fragment.
[[nodiscard]] inline Fragment interpolate(
    const Interpolants& in, const TriangleSetup& setup, PixelPos pixel, const EdgeValues& e
) {
    const Interpolator interpolator(in);
    Fragment f = place_fragment(interpolator, setup, pixel, e);
    interpolate_varyings(interpolator, f);
    return f;
}

} // namespace hs::raster
