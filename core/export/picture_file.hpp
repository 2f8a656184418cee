// Pictures through OpenImageIO: PNG for eyes, EXR for numbers.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/export/attributes.hpp"
#include "core/export/layers.hpp"
#include "core/framebuffer/color.hpp"

#include <filesystem>
#include <span>

namespace hs::exporting {

/// One layer as PNG. Color: 8 bits a channel. Triangle numbers: a color of its own for each, see
/// `number_color`. Everything else in 16-bit gray: depth and weights over [0, 1], counts as they
/// are, edge functions from their smallest to their largest value; the text `halfspace:range`
/// says what black and white mean. Values outside are clamped.
Result<Done>
write_png(const std::filesystem::path& path, const Layer& layer, const Attributes& attributes);

/// Pixels as they are.
Result<Done> write_png(
    const std::filesystem::path& path,
    int width,
    int height,
    std::span<const framebuffer::Rgba8> pixels,
    const Attributes& attributes
);

/// Any number of layers of one size, every channel in 32-bit float.
Result<Done> write_exr(
    const std::filesystem::path& path, std::span<const Layer> layers, const Attributes& attributes
);

/// The color of a number from −1 (opaque black) to 2^24 − 2: neighbours differ strongly, and each
/// number has a color of its own, so that a picture can be read back. The bits of number + 1 are
/// dealt to red, green and blue in turn, lowest bit first, each channel filled from its highest
/// bit down (the color map of the PASCAL Visual Object Classes challenge, 2005, in its full 24
/// bits).
[[nodiscard]] framebuffer::Rgba8 number_color(std::int64_t number);

} // namespace hs::exporting
