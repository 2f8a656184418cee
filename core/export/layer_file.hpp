// Buffers as numbers for notebooks and spreadsheets: NPZ and CSV.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/export/attributes.hpp"
#include "core/export/layers.hpp"

#include <filesystem>
#include <span>

namespace hs::exporting {

/// One H × W (× channels) array per layer, named like it: float32, triangle numbers and counts
/// int32. Attributes go to manifest.json.
Result<Done> write_npz(
    const std::filesystem::path& path, std::span<const Layer> layers, const Attributes& attributes
);

/// One row per pixel: x, y, then every channel of every layer, floats so that they read back
/// exactly. Layers are of one size.
Result<Done> write_csv(const std::filesystem::path& path, std::span<const Layer> layers);

} // namespace hs::exporting
