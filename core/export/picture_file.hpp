// Pictures through OpenImageIO: PNG for eyes, EXR for numbers.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/export/layers.hpp"
#include "core/framebuffer/color.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace hs::exporting {

/// Written into the file as text attributes: ("halfspace:step", "object 0 / triangle 12").
using Attributes = std::vector<std::pair<std::string, std::string>>;

/// One layer as PNG: color in 8 bits; depth in 16-bit gray over [0, 1]; triangle numbers and counts
/// in 16-bit gray, background 0 and triangle n as n + 1; anything else in 16-bit gray from its
/// smallest to its largest value. Values outside the range are clamped.
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

} // namespace hs::exporting
