// Color and depth attachments of an untraced frame.
#pragma once

#include "core/base/hash.hpp"
#include "core/base/pixel.hpp"
#include "core/framebuffer/color.hpp"
#include "core/framebuffer/samples.hpp"
#include "core/scene/settings.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hs::framebuffer {

/// Where fragments read and write. A pixel is closed once something was written where triangles
/// come front to back; nobody asks elsewhere. A framebuffer is one; a recording and a re-run bring
/// their own. Pixels are inside the image.
template <typename T>
concept PixelTarget =
    requires(T target, const T& constant, PixelPos pixel, glm::vec4 color, float depth) {
    { constant.depth(pixel) } -> std::convertible_to<float>;
    { constant.color(pixel) } -> std::convertible_to<glm::vec4>;
    { constant.closed(pixel) } -> std::convertible_to<bool>;
    target.set_depth(pixel, depth);
    target.set_color(pixel, color);
    target.close(pixel);
};

/// Where the fragments of a frame with several samples a pixel read and write.
template <typename T>
concept SampleTarget = PixelTarget<T> &&
    requires(T target, const T& constant, PixelPos pixel, PixelSamples samples) {
    { constant.samples(pixel) } -> std::convertible_to<PixelSamples>;
    target.set_samples(pixel, samples);
};

class Framebuffer {
public:
    /// Cleared to the settings' background and depth clear value.
    explicit Framebuffer(const scene::Settings& settings);
    /// Every pixel as it was made. Threads share the rows: an image of many pixels is cleared as
    /// fast as memory can be written.
    void clear(unsigned threads = 1);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] scene::ColorFormat color_format() const { return color_format_; }

    [[nodiscard]] float depth(PixelPos p) const { return depth_[index(p)]; }
    [[nodiscard]] glm::vec4 color(PixelPos p) const {
        return color_format_ == scene::ColorFormat::rgba8 ? unpack(rgba8_[index(p)])
                                                          : rgba32f_[index(p)];
    }
    void set_depth(PixelPos p, float depth) { depth_[index(p)] = depth; }
    void set_color(PixelPos p, const glm::vec4& color) {
        if (color_format_ == scene::ColorFormat::rgba8) {
            rgba8_[index(p)] = pack(color);
        } else {
            rgba32f_[index(p)] = color;
        }
    }

    [[nodiscard]] bool closed(PixelPos p) const { return closed_[index(p)] != 0; }
    void close(PixelPos p) { closed_[index(p)] = 1; }
    /// Several samples a pixel: what they hold, beside the pixel's own color and depth, which are
    /// what resolving makes of them.
    [[nodiscard]] PixelSamples samples(PixelPos p) const;
    /// Rounds the colors as the format does.
    void set_samples(PixelPos p, const PixelSamples& samples);

    /// Row 0 first; only for rgba8.
    [[nodiscard]] const std::vector<Rgba8>& rgba8() const { return rgba8_; }

    /// Over color and depth bits of every pixel, and of its samples, in row order. Equal digests
    /// mean bit-identical buffers.
    [[nodiscard]] std::uint64_t digest() const;

private:
    [[nodiscard]] std::size_t index(PixelPos p) const {
        return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(p.x);
    }
    [[nodiscard]] std::size_t first_sample(PixelPos p) const {
        return index(p) * static_cast<std::size_t>(samples_);
    }

    int width_;
    int height_;
    scene::ColorFormat color_format_;
    glm::vec4 background_;
    float clear_depth_;
    std::vector<Rgba8> rgba8_;
    std::vector<glm::vec4> rgba32f_;
    std::vector<float> depth_;
    std::vector<std::uint8_t> closed_; ///< empty where triangles do not come front to back

    int samples_ = 1;
    std::vector<Rgba8> sample_rgba8_; ///< pixel by pixel; empty with one sample
    std::vector<glm::vec4> sample_rgba32f_;
    std::vector<float> sample_depth_;
};

} // namespace hs::framebuffer
