// What a re-run reads from the framebuffer: the pixel as it was before a logged fragment.
#pragma once

#include "core/trace/detail.hpp"

namespace hs::trace {

/// A target for re-runs. `fragment` is the number of the fragment now being drawn, kept up to date
/// by the sink that listens to the re-run. Writing changes nothing: what was written is in the log
/// already.
class PastPixels {
public:
    PastPixels(const Recording& recording, const std::uint32_t& fragment)
        : recording_(recording), fragment_(fragment) {}

    [[nodiscard]] float depth(PixelPos) const {
        return exists() ? pixel_before(recording_, fragment_).depth : 0.0F;
    }
    [[nodiscard]] glm::vec4 color(PixelPos) const {
        return exists() ? pixel_before(recording_, fragment_).color : glm::vec4{0.0F};
    }
    [[nodiscard]] bool closed(PixelPos) const {
        return exists() && pixel_before(recording_, fragment_).triangle != no_triangle;
    }
    void close(PixelPos) {}
    void set_depth(PixelPos, float) {}
    void set_color(PixelPos, const glm::vec4&) {}

    /// Several samples a pixel: as the fragment before left them.
    [[nodiscard]] framebuffer::PixelSamples samples(PixelPos) const {
        return exists() ? recording_.samples.after(recording_.fragments[fragment_].previous)
                        : recording_.samples.cleared();
    }
    void set_samples(PixelPos, const framebuffer::PixelSamples&) {}

private:
    /// A re-run that has diverged may draw fragments that were never logged; it is reported, not
    /// followed.
    [[nodiscard]] bool exists() const { return fragment_ < recording_.fragments.size(); }

    const Recording& recording_;
    const std::uint32_t& fragment_;
};

} // namespace hs::trace
