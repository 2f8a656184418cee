// Where the samples of a pixel lie.
//
// Direct3D 11.1's standard multisample patterns (D3D11_STANDARD_MULTISAMPLE_PATTERN), given there
// in sixteenths of a pixel from the center, y down. That of 4 samples is Mesa llvmpipe's, too.
#pragma once

#include "core/base/fixed.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace hs::raster {

inline constexpr int max_samples = 8;

/// Which samples of a pixel are meant: bit s is sample s.
using CoverageMask = std::uint8_t;

[[nodiscard]] inline bool has_sample(CoverageMask mask, int sample) {
    return (static_cast<unsigned>(mask) >> static_cast<unsigned>(sample) & 1U) != 0;
}
[[nodiscard]] inline CoverageMask mask_of(int sample) {
    return static_cast<CoverageMask>(1U << static_cast<unsigned>(sample));
}

/// A sample's place, relative to its pixel's center.
struct SampleOffset {
    std::int32_t x = 0; ///< in 1/256 pixel
    std::int32_t y = 0; ///< in 1/256 pixel, down
    friend bool operator==(const SampleOffset&, const SampleOffset&) = default;
};

namespace detail {

[[nodiscard]] constexpr SampleOffset sixteenths(int x, int y) {
    return {x * (subpixel_scale / 16), y * (subpixel_scale / 16)};
}

inline constexpr std::array<SampleOffset, 1> one_sample{};
inline constexpr std::array<SampleOffset, 2> two_samples{{sixteenths(4, 4), sixteenths(-4, -4)}};
inline constexpr std::array<SampleOffset, 4> four_samples{{
    sixteenths(-2, -6),
    sixteenths(6, -2),
    sixteenths(-6, 2),
    sixteenths(2, 6),
}};
inline constexpr std::array<SampleOffset, 8> eight_samples{{
    sixteenths(1, -3),
    sixteenths(-1, 3),
    sixteenths(5, 1),
    sixteenths(-3, -5),
    sixteenths(-5, 5),
    sixteenths(-7, -1),
    sixteenths(3, 7),
    sixteenths(7, -7),
}};

} // namespace detail

/// The samples of every pixel, in order. `samples` is 1, 2, 4 or 8; one sample is the center.
[[nodiscard]] inline std::span<const SampleOffset> sample_pattern(int samples) {
    switch (samples) {
    case 2: return detail::two_samples;
    case 4: return detail::four_samples;
    case 8: return detail::eight_samples;
    default: return detail::one_sample;
    }
}

/// No sample lies farther from its pixel's center than this along x or y: half a pixel.
inline constexpr std::int32_t sample_reach = subpixel_scale / 2;

} // namespace hs::raster
