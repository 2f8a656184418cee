#include "tests/support/paths.hpp"

#include <cstdlib>

namespace hs::test {

namespace {

std::optional<std::filesystem::path> if_exists(std::filesystem::path path) {
    if (path.empty() || !std::filesystem::exists(path)) {
        return std::nullopt;
    }
    return path;
}

} // namespace

std::filesystem::path source_dir() {
    return HALFSPACE_SOURCE_DIR;
}

std::optional<std::filesystem::path> program() {
    return if_exists(HALFSPACE_PROGRAM);
}

std::optional<std::filesystem::path> data_file(std::string_view name) {
    const char* const chosen = std::getenv("HALFSPACE_DATA");
    const std::filesystem::path folder = chosen != nullptr ? chosen : HALFSPACE_DATA_DIR;
    return if_exists(folder / name);
}

} // namespace hs::test
