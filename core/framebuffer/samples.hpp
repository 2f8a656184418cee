// What a pixel holds when it is sampled at several points, and the one color they resolve to.
//
// OpenGL 4.6, section 18.3.1 (resolving by glBlitFramebuffer). It leaves open how samples become
// one color; here it is their average, in rgba8 of the stored integers, rounded to nearest, ties to
// even. The depth of a resolved pixel is its first sample's (Vulkan: RESOLVE_MODE_SAMPLE_ZERO).
#pragma once

#include "core/base/hash.hpp"
#include "core/framebuffer/color.hpp"
#include "core/scene/settings.hpp"

#include <glm/vec4.hpp>

#include <array>

namespace hs::framebuffer {

struct SampleValue {
    glm::vec4 color{0.0F};
    float depth = 0.0F;
    friend bool operator==(const SampleValue&, const SampleValue&) = default;
};

/// The samples of one pixel; those beyond `count` keep their defaults.
struct PixelSamples {
    int count = 1;
    std::array<SampleValue, 8> values{};

    [[nodiscard]] const SampleValue& operator[](int sample) const {
        return values[static_cast<unsigned>(sample)];
    }
    [[nodiscard]] SampleValue& operator[](int sample) {
        return values[static_cast<unsigned>(sample)];
    }
    friend bool operator==(const PixelSamples&, const PixelSamples&) = default;
};

/// All samples of a pixel alike.
[[nodiscard]] PixelSamples uniform_samples(int count, const SampleValue& value);
/// As a frame's samples are cleared.
[[nodiscard]] PixelSamples cleared_samples(const scene::Settings& settings);

/// The samples' average, as the format stores it. Samples that agree resolve to what they hold.
[[nodiscard]] SampleValue resolve(const PixelSamples& samples, scene::ColorFormat format);

/// Color and depth bits of every sample.
void add_samples(Digest& digest, const PixelSamples& samples, scene::ColorFormat format);

} // namespace hs::framebuffer
