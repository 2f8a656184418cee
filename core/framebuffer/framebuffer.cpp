#include "core/framebuffer/framebuffer.hpp"

#include "core/framebuffer/depth.hpp"

namespace hs::framebuffer {

Framebuffer::Framebuffer(const scene::Settings& settings)
    : width_(settings.width),
      height_(settings.height),
      color_format_(settings.color_format),
      samples_(settings.samples) {
    const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    if (color_format_ == scene::ColorFormat::rgba8) {
        rgba8_.assign(pixels, pack(settings.background));
    } else {
        rgba32f_.assign(pixels, settings.background);
    }
    const float depth = store_depth(settings.depth_clear(), settings.depth_format);
    depth_.assign(pixels, depth);
    if (samples_ > 1) {
        const std::size_t all = pixels * static_cast<std::size_t>(samples_);
        if (color_format_ == scene::ColorFormat::rgba8) {
            sample_rgba8_.assign(all, pack(settings.background));
        } else {
            sample_rgba32f_.assign(all, settings.background);
        }
        sample_depth_.assign(all, depth);
    }
    closed_.assign(settings.closes_pixels() ? pixels : 0, 0);
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
