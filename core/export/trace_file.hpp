// A recording as a file: a zip of .npy columns and a manifest, which `numpy.load` opens.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/scene/scene_file.hpp"
#include "core/trace/recording.hpp"

#include <filesystem>
#include <memory>
#include <span>

namespace hs::exporting {

/// Saves every table with its derived columns, settings, counters, digests, and verbatim the
/// scene's file and the meshes and images it refers to. `assignments` are the changes the scene
/// was opened with: file and assignments together make the frame again. Written whole or not at
/// all.
Result<Done> save_trace(
    const std::shared_ptr<const trace::Recording>& recording,
    const std::filesystem::path& path,
    std::span<const scene::Assignment> assignments = {}
);

} // namespace hs::exporting
