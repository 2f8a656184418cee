#include "core/export/whole_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace hs::exporting {
namespace {

namespace fs = std::filesystem;

Diagnostic cannot_write(const fs::path& path, std::string_view why) {
    return {.file = path.string(), .message = fmt::format("cannot be written: {}", why)};
}

/// Removes the temporary file unless it was renamed away.
class TemporaryFile {
public:
    explicit TemporaryFile(const fs::path& target)
        : path_(
              target.parent_path() /
              fmt::format(
                  ".{}.{}{}", target.stem().string(), ::getpid(), target.extension().string()
              )
          ) {}
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    TemporaryFile(TemporaryFile&&) = delete;
    TemporaryFile& operator=(TemporaryFile&&) = delete;
    ~TemporaryFile() {
        std::error_code ignored; // nothing more can be done about a file that will not go
        fs::remove(path_, ignored);
    }
    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

/// Forces the content to the disk: a full disk shows here at the latest. Empty when it worked.
std::string flush_to_disk(const fs::path& path) {
    const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
    if (file < 0) {
        return std::strerror(errno);
    }
    std::string problem = ::fsync(file) == 0 ? "" : std::strerror(errno);
    if (::close(file) != 0 && problem.empty()) {
        problem = std::strerror(errno);
    }
    return problem;
}

} // namespace

Result<Done> write_whole(
    const fs::path& path, const std::function<Result<Done>(const fs::path& temporary)>& write
) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
        return cannot_write(path, "it is a folder; name a file in it");
    }
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path{"."};
    if (!fs::is_directory(folder, error)) {
        return cannot_write(path, fmt::format("the folder {} does not exist", folder.string()));
    }
    if (fs::exists(path, error) && !fs::is_regular_file(path, error)) {
        return cannot_write(path, "it is not a regular file");
    }

    const TemporaryFile temporary(path);
    if (Result<Done> written = write(temporary.path()); !written) {
        return written;
    }
    if (const std::string problem = flush_to_disk(temporary.path()); !problem.empty()) {
        return cannot_write(path, problem);
    }
    fs::rename(temporary.path(), path, error);
    if (error) {
        return cannot_write(path, error.message());
    }
    return done;
}

Result<Done> write_text(const fs::path& path, std::string_view text) {
    return write_whole(path, [&](const fs::path& temporary) -> Result<Done> {
        std::ofstream file(temporary, std::ios::binary);
        file.write(text.data(), static_cast<std::streamsize>(text.size()));
        file.close();
        if (!file) {
            return cannot_write(path, std::strerror(errno));
        }
        return done;
    });
}

} // namespace hs::exporting
