// What the screen view shows, written to a file.
#pragma once

#include "app/viewer/background.hpp"
#include "app/viewer/document.hpp"
#include "app/viewer/state.hpp"

#include <filesystem>
#include <string>

namespace hs::viewer {

/// A file name for the buffer that is shown: "bunny-depth.exr".
std::string export_name(const Document& document, ScreenContent content);

/// The work of writing that buffer as it is at the playhead; the ending chooses the format: .png,
/// .exr, .npz or .csv. Errors: nothing to write here, a name or folder that does not do.
Result<Background::Job>
export_job(const Document& document, ScreenContent content, const std::filesystem::path& file);

} // namespace hs::viewer
