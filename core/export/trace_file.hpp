// A recording as a file: a zip of .npy columns and a manifest, which `numpy.load` opens.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/trace/recording.hpp"

#include <filesystem>

namespace hs::exporting {

/// Saves every table with its derived columns, the scene's text and settings, the meshes and images
/// it refers to, counters and digests. Written whole or not at all.
Result<Done> save_trace(
    const std::shared_ptr<const trace::Recording>& recording, const std::filesystem::path& path
);

} // namespace hs::exporting
