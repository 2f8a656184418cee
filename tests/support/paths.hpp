#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>

namespace hs::test {

/// The top of the source tree.
[[nodiscard]] inline std::filesystem::path source_dir() {
    return HALFSPACE_SOURCE_DIR;
}

/// A mesh of the shared collection, which is not part of the repository: a test that wants one
/// says so with WARN and returns when there is none.
[[nodiscard]] inline std::optional<std::filesystem::path> data_file(std::string_view name) {
    const char* const chosen = std::getenv("HALFSPACE_DATA");
    const std::filesystem::path folder = chosen != nullptr ? chosen : HALFSPACE_DATA_DIR;
    std::filesystem::path file = folder / name;
    if (!std::filesystem::exists(file)) {
        return std::nullopt;
    }
    return file;
}

} // namespace hs::test
