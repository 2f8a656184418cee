// A folder that is gone after the test, whatever the test did.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hs::tests {

class TemporaryFolder {
public:
    TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    TemporaryFolder(TemporaryFolder&&) = delete;
    TemporaryFolder& operator=(TemporaryFolder&&) = delete;
    ~TemporaryFolder();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path operator/(std::string_view name) const {
        return path_ / name;
    }
    /// Names of everything in it, hidden files too, sorted.
    [[nodiscard]] std::vector<std::string> names() const;
    /// Writes a file and returns its path.
    [[nodiscard]] std::filesystem::path write(std::string_view name, std::string_view text) const;

private:
    std::filesystem::path path_;
};

std::string read_text(const std::filesystem::path& path);

} // namespace hs::tests
