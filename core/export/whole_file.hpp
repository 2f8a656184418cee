// Files are written whole or not at all: to a temporary name in the same folder, then renamed.
#pragma once

#include "core/base/diagnostic.hpp"

#include <filesystem>
#include <functional>
#include <string_view>

namespace hs::exporting {

/// Calls `write` with a temporary path beside `path`; when it succeeds, flushes the file to the
/// disk and renames it. On any failure, exceptions included, nothing is left and an older file of
/// that name stays as it was. `write` returns its own diagnostic, located at `path`.
Result<Done> write_whole(
    const std::filesystem::path& path,
    const std::function<Result<Done>(const std::filesystem::path& temporary)>& write
);

/// Writes text that way.
Result<Done> write_text(const std::filesystem::path& path, std::string_view text);

} // namespace hs::exporting
