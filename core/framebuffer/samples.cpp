#include "core/framebuffer/samples.hpp"

#include "core/framebuffer/depth.hpp"

namespace hs::framebuffer {
namespace {

/// n / count to the nearest integer, ties to even.
std::uint32_t rounded_quotient(std::uint32_t n, std::uint32_t count) {
    const std::uint32_t quotient = n / count;
    const std::uint32_t twice_rest = 2 * (n % count);
    const bool up = twice_rest > count || (twice_rest == count && quotient % 2 == 1);
    return quotient + (up ? 1 : 0);
}

/// One 8-bit channel, averaged in integers.
float average_unorm8(const PixelSamples& samples, int channel) {
    std::uint32_t sum = 0;
    for (int s = 0; s < samples.count; ++s) {
        sum += to_unorm8(samples[s].color[channel]);
    }
    return static_cast<float>(rounded_quotient(sum, static_cast<std::uint32_t>(samples.count))) /
           255.0F;
}

/// Sums neighbors pair by pair, so that equal colors are doubled, which is exact.
glm::vec4 average_float(const PixelSamples& samples) {
    std::array<glm::vec4, 8> sums{};
    for (int s = 0; s < samples.count; ++s) {
        sums[static_cast<unsigned>(s)] = samples[s].color;
    }
    for (auto left = static_cast<unsigned>(samples.count); left > 1; left /= 2) {
        for (unsigned i = 0; i < left / 2; ++i) {
            sums[i] = sums[2 * i] + sums[2 * i + 1];
        }
    }
    return sums[0] * (1.0F / static_cast<float>(samples.count));
}

} // namespace

PixelSamples uniform_samples(int count, const SampleValue& value) {
    PixelSamples samples;
    samples.count = count;
    for (int s = 0; s < count; ++s) {
        samples[s] = value;
    }
    return samples;
}

PixelSamples cleared_samples(const scene::Settings& settings) {
    const bool rounded = settings.color_format == scene::ColorFormat::rgba8;
    return uniform_samples(
        settings.samples,
        {rounded ? unpack(pack(settings.background)) : settings.background,
         store_depth(settings.depth_clear(), settings.depth_format)}
    );
}

SampleValue resolve(const PixelSamples& samples, scene::ColorFormat format) {
    SampleValue result{.depth = samples[0].depth};
    if (format == scene::ColorFormat::rgba32f) {
        result.color = average_float(samples);
        return result;
    }
    for (int channel = 0; channel < 4; ++channel) {
        result.color[channel] = average_unorm8(samples, channel);
    }
    return result;
}

void add_samples(Digest& digest, const PixelSamples& samples, scene::ColorFormat format) {
    for (int s = 0; s < samples.count; ++s) {
        const glm::vec4& color = samples[s].color;
        if (format == scene::ColorFormat::rgba8) {
            digest.add(pack(color));
        } else {
            for (const float channel : {color.r, color.g, color.b, color.a}) {
                digest.add(channel);
            }
        }
        digest.add(samples[s].depth);
    }
}

} // namespace hs::framebuffer
