#include "core/framebuffer/framebuffer.hpp"

#include "core/framebuffer/depth.hpp"

namespace hs::framebuffer {

Framebuffer::Framebuffer(const scene::Settings& settings)
    : width_(settings.width), height_(settings.height), color_format_(settings.color_format) {
    const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    if (color_format_ == scene::ColorFormat::rgba8) {
        rgba8_.assign(pixels, pack(settings.background));
    } else {
        rgba32f_.assign(pixels, settings.background);
    }
    depth_.assign(pixels, store_depth(settings.depth_clear(), settings.depth_format));
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
    }
    return digest.value();
}

} // namespace hs::framebuffer
