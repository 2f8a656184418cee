#include "core/export/whole_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace hs::exporting {
namespace {

namespace fs = std::filesystem;

// A signal handler may only touch a lock-free atomic
std::atomic<bool> cancelled{false}; // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
static_assert(std::atomic<bool>::is_always_lock_free);

Diagnostic cannot_write(const fs::path& path, std::string_view why) {
    return {.file = path.string(), .message = fmt::format("cannot be written: {}", why)};
}

std::string system_message(int number) {
    return std::generic_category().message(number);
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path{"."};
}

/// Removes the temporary file unless it was renamed away.
class TemporaryFile {
public:
    // A short name of its own, so that a name of full length can still be written. It keeps the
    // ending: image libraries choose the format by it.
    explicit TemporaryFile(const fs::path& target)
        : path_(
              folder_of(target) /
              fmt::format(".halfspace-{}{}", ::getpid(), target.extension().string())
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

/// Forces a file's content, or a folder's entries, to the disk. Empty when it worked.
std::string flush_to_disk(const fs::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        return system_message(errno);
    }
    std::string problem = ::fsync(file) == 0 ? "" : system_message(errno);
    ::close(file);
    return problem;
}

/// A new file, written piece by piece.
// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): it is final
class FileSink final : public ByteSink {
public:
    explicit FileSink(const fs::path& path)
        : file_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
        if (file_ < 0) {
            error_ = errno;
        }
    }
    FileSink(const FileSink&) = delete;
    FileSink& operator=(const FileSink&) = delete;
    FileSink(FileSink&&) = delete;
    FileSink& operator=(FileSink&&) = delete;
    ~FileSink() {
        if (file_ >= 0) {
            ::close(file_);
        }
    }

    /// Writes what still waits. Empty when all of it was written.
    std::string finish() {
        flush();
        if (file_ >= 0 && ::close(file_) != 0 && error_ == 0) {
            error_ = errno;
        }
        file_ = -1;
        return error_ == 0 ? "" : system_message(error_);
    }

private:
    bool pass_on(std::span<const std::byte> piece) override {
        while (error_ == 0 && !piece.empty()) {
            const ssize_t count = ::write(file_, piece.data(), piece.size());
            if (count >= 0) {
                piece = piece.subspan(static_cast<std::size_t>(count));
            } else if (errno != EINTR) {
                error_ = errno;
            }
            if (writing_cancelled()) {
                error_ = ECANCELED;
            }
        }
        return error_ == 0;
    }

    int file_;
    int error_ = 0;
};

} // namespace

void ByteSink::write(std::span<const std::byte> bytes) {
    constexpr std::size_t piece = std::size_t{1} << 20U;
    if (failed_) {
        return;
    }
    if (waiting_.size() + bytes.size() > piece) {
        flush();
    }
    if (bytes.size() >= piece) {
        failed_ = failed_ || !pass_on(bytes);
        return;
    }
    const auto* const text = reinterpret_cast<const char*>(bytes.data());
    waiting_.append(text, bytes.size());
}

void ByteSink::flush() {
    if (!failed_ && !waiting_.empty()) {
        failed_ = !pass_on(std::as_bytes(std::span{waiting_.data(), waiting_.size()}));
    }
    waiting_.clear();
}

Result<Done> check_writable(const fs::path& path) {
    std::error_code error;
    if (path.empty() || !path.has_filename()) {
        return cannot_write(path, "it names no file");
    }
    if (fs::is_directory(path, error)) {
        return cannot_write(path, "it is a folder; name a file in it");
    }
    const fs::path folder = folder_of(path);
    if (!fs::is_directory(folder, error)) {
        return cannot_write(path, fmt::format("there is no folder '{}'", folder.string()));
    }
    if (fs::exists(path, error) && !fs::is_regular_file(path, error)) {
        return cannot_write(path, "it is not a regular file");
    }
    if (::access(folder.c_str(), W_OK) != 0) {
        return cannot_write(path, system_message(errno));
    }
    return done;
}

Result<Done>
write_whole(const fs::path& path, const std::function<Result<Done>(const fs::path&)>& write) {
    if (Result<Done> writable = check_writable(path); !writable) {
        return writable;
    }
    const TemporaryFile temporary(path);
    if (Result<Done> written = write(temporary.path()); !written) {
        return written;
    }
    if (const std::string problem = flush_to_disk(temporary.path()); !problem.empty()) {
        return cannot_write(path, problem);
    }
    if (writing_cancelled()) {
        return cannot_write(path, system_message(ECANCELED));
    }
    std::error_code error;
    fs::rename(temporary.path(), path, error);
    if (error) {
        return cannot_write(path, error.message());
    }
    // The content is safe; that the new name is, too, is asked for but no reason to complain
    flush_to_disk(folder_of(path));
    return done;
}

Result<Done> write_bytes(const fs::path& path, const std::function<void(ByteSink&)>& produce) {
    return write_whole(path, [&](const fs::path& temporary) -> Result<Done> {
        FileSink file(temporary);
        produce(file);
        if (const std::string problem = file.finish(); !problem.empty()) {
            return cannot_write(path, problem);
        }
        return done;
    });
}

Result<Done> write_text(const fs::path& path, std::string_view text) {
    return write_bytes(path, [text](ByteSink& sink) { sink.write(text); });
}

void cancel_writing() noexcept {
    cancelled = true;
}

bool writing_cancelled() noexcept {
    return cancelled;
}

} // namespace hs::exporting
