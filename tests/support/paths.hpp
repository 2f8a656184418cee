#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace hs::test {

/// The top of the source tree.
[[nodiscard]] std::filesystem::path source_dir();

/// The program `halfspace` of this build; nothing where it is not built.
[[nodiscard]] std::optional<std::filesystem::path> program();

/// A mesh of the shared collection, which is not part of the repository: a test that wants one
/// says so with WARN and returns when there is none. HALFSPACE_DATA of the environment names
/// another folder.
[[nodiscard]] std::optional<std::filesystem::path> data_file(std::string_view name);

} // namespace hs::test
