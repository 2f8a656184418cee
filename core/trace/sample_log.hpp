// What a pixel's samples hold after each fragment that reached it, in frames with several samples a
// pixel.
//
// The log is the sample buffer: a pixel's samples at any moment are those after the last fragment
// that reached it, so neither checkpoints nor playheads keep a copy of them. Per fragment and
// sample, 8 bytes in rgba8 frames and 20 in rgba32f.
#pragma once

#include "core/framebuffer/samples.hpp"
#include "core/trace/chunked.hpp"
#include "core/trace/pixel_buffer.hpp"

#include <cstddef>
#include <cstdint>

namespace hs::trace {

class SampleLog {
public:
    SampleLog() = default;
    explicit SampleLog(const scene::Settings& settings);

    /// Whether the frame has several samples a pixel; nothing else is called where it has not.
    [[nodiscard]] bool active() const { return cleared_.count > 1; }

    /// The samples a pixel holds before any fragment reached it.
    [[nodiscard]] const framebuffer::PixelSamples& cleared() const { return cleared_; }

    /// After a fragment, or as cleared after `no_fragment`.
    [[nodiscard]] framebuffer::PixelSamples after(std::uint32_t fragment) const;

    /// For the next fragment, as the format stores it.
    void push_back(const framebuffer::PixelSamples& samples);

    /// As the color format stores them.
    [[nodiscard]] framebuffer::PixelSamples stored(const framebuffer::PixelSamples& samples) const;

    [[nodiscard]] std::size_t bytes() const;

private:
    framebuffer::PixelSamples cleared_;
    bool float_color_ = false;
    Chunked<framebuffer::Rgba8> rgba8_; ///< sample by sample of one fragment, then the next
    Chunked<glm::vec4> rgba32f_;
    Chunked<float> depth_;
};

} // namespace hs::trace
