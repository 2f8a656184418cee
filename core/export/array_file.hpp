// Buffers as numbers for notebooks and spreadsheets: NPZ and CSV.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/export/layers.hpp"

#include <filesystem>
#include <span>

namespace hs::exporting {

/// One H × W (× channels) float32 array per layer, named like it.
Result<Done> write_npz(const std::filesystem::path& path, std::span<const Layer> layers);

/// One row per pixel: x, y, then every channel of every layer. Layers are of one size.
Result<Done> write_csv(const std::filesystem::path& path, std::span<const Layer> layers);

} // namespace hs::exporting
