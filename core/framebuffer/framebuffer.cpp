#include "core/framebuffer/framebuffer.hpp"

#include "core/base/parallel.hpp"
#include "core/framebuffer/depth.hpp"

#include <algorithm>

namespace hs::framebuffer {

namespace {

struct PixelRange {
    std::size_t first;
    std::size_t last;
};

/// Fills the part of a buffer that belongs to some pixels. Buffers that the settings do not need
/// are empty.
template <typename Value>
void fill(
    std::vector<Value>& buffer, std::size_t per_pixel, PixelRange pixels, const Value& value
) {
    if (!buffer.empty()) {
        const auto at = [&](std::size_t pixel) {
            return buffer.begin() + static_cast<std::ptrdiff_t>(pixel * per_pixel);
        };
        std::fill(at(pixels.first), at(pixels.last), value);
    }
}

} // namespace

Framebuffer::Framebuffer(const scene::Settings& settings)
    : width_(settings.width),
      height_(settings.height),
      color_format_(settings.color_format),
      background_(settings.background),
      clear_depth_(store_depth(settings.depth_clear(), settings.depth_format)),
      samples_(settings.samples) {
    const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    const bool rgba8 = color_format_ == scene::ColorFormat::rgba8;
    rgba8_.resize(rgba8 ? pixels : 0);
    rgba32f_.resize(rgba8 ? 0 : pixels);
    depth_.resize(pixels);
    closed_.resize(settings.closes_pixels() ? pixels : 0);
    if (samples_ > 1) {
        const std::size_t all = pixels * static_cast<std::size_t>(samples_);
        sample_rgba8_.resize(rgba8 ? all : 0);
        sample_rgba32f_.resize(rgba8 ? 0 : all);
        sample_depth_.resize(all);
    }
    clear();
}

void Framebuffer::clear(unsigned threads) {
    constexpr std::size_t grain = 65536; // pixels
    const Rgba8 packed = pack(background_);
    const auto samples = static_cast<std::size_t>(samples_);
    parallel_ranges(depth_.size(), threads, grain, [&](std::size_t first, std::size_t last) {
        const PixelRange pixels{first, last};
        fill(rgba8_, 1, pixels, packed);
        fill(rgba32f_, 1, pixels, background_);
        fill(depth_, 1, pixels, clear_depth_);
        fill(closed_, 1, pixels, std::uint8_t{0});
        fill(sample_rgba8_, samples, pixels, packed);
        fill(sample_rgba32f_, samples, pixels, background_);
        fill(sample_depth_, samples, pixels, clear_depth_);
    });
}

PixelSamples Framebuffer::samples(PixelPos p) const {
    const std::size_t first = first_sample(p);
    PixelSamples result;
    result.count = samples_;
    for (int s = 0; s < samples_; ++s) {
        const std::size_t i = first + static_cast<std::size_t>(s);
        result[s] = {
            color_format_ == scene::ColorFormat::rgba8 ? unpack(sample_rgba8_[i])
                                                       : sample_rgba32f_[i],
            sample_depth_[i]};
    }
    return result;
}

void Framebuffer::set_samples(PixelPos p, const PixelSamples& samples) {
    const std::size_t first = first_sample(p);
    for (int s = 0; s < samples_; ++s) {
        const std::size_t i = first + static_cast<std::size_t>(s);
        if (color_format_ == scene::ColorFormat::rgba8) {
            sample_rgba8_[i] = pack(samples[s].color);
        } else {
            sample_rgba32f_[i] = samples[s].color;
        }
        sample_depth_[i] = samples[s].depth;
    }
}

std::uint64_t Framebuffer::digest() const {
    Digest digest;
    for (std::size_t i = 0; i < depth_.size(); ++i) {
        if (color_format_ == scene::ColorFormat::rgba8) {
            digest.add(rgba8_[i]);
        } else {
            digest.add(rgba32f_[i].r);
            digest.add(rgba32f_[i].g);
            digest.add(rgba32f_[i].b);
            digest.add(rgba32f_[i].a);
        }
        digest.add(depth_[i]);
        if (samples_ > 1) {
            const auto pixel = static_cast<int>(i);
            add_samples(digest, samples({pixel % width_, pixel / width_}), color_format_);
        }
    }
    return digest.value();
}

} // namespace hs::framebuffer
