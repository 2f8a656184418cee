#include "core/trace/sample_log.hpp"

#include "core/framebuffer/color.hpp"

namespace hs::trace {

SampleLog::SampleLog(const scene::Settings& settings)
    : cleared_(framebuffer::cleared_samples(settings)),
      float_color_(settings.color_format == scene::ColorFormat::rgba32f) {}

framebuffer::PixelSamples SampleLog::after(std::uint32_t fragment) const {
    if (fragment == no_fragment) {
        return cleared_;
    }
    framebuffer::PixelSamples samples;
    samples.count = cleared_.count;
    const std::size_t first = std::size_t{fragment} * static_cast<std::size_t>(cleared_.count);
    for (int s = 0; s < samples.count; ++s) {
        const std::size_t i = first + static_cast<std::size_t>(s);
        samples[s] = {float_color_ ? rgba32f_[i] : framebuffer::unpack(rgba8_[i]), depth_[i]};
    }
    return samples;
}

void SampleLog::push_back(const framebuffer::PixelSamples& samples) {
    for (int s = 0; s < samples.count; ++s) {
        if (float_color_) {
            rgba32f_.push_back(samples[s].color);
        } else {
            rgba8_.push_back(framebuffer::pack(samples[s].color));
        }
        depth_.push_back(samples[s].depth);
    }
}

framebuffer::PixelSamples SampleLog::stored(const framebuffer::PixelSamples& samples) const {
    framebuffer::PixelSamples result = samples;
    for (int s = 0; s < samples.count && !float_color_; ++s) {
        result[s].color = framebuffer::unpack(framebuffer::pack(samples[s].color));
    }
    return result;
}

std::size_t SampleLog::bytes() const {
    return rgba8_.bytes() + rgba32f_.bytes() + depth_.bytes();
}

} // namespace hs::trace
