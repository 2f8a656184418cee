// Files are written whole or not at all: under a temporary name in the same folder, then renamed.
#pragma once

#include "core/base/diagnostic.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace hs::exporting {

/// Calls `write` with a temporary path beside `path`; when it succeeds, flushes the file to the
/// disk and renames it. On any failure, exceptions included, nothing is left and an older file of
/// that name stays as it was. `write` returns its own diagnostic, located at `path`.
Result<Done> write_whole(
    const std::filesystem::path& path,
    const std::function<Result<Done>(const std::filesystem::path& temporary)>& write
);

/// What is wrong with writing to `path`, as far as it can be said before anything is written:
/// worth asking before a long computation.
Result<Done> check_writable(const std::filesystem::path& path);

/// Takes bytes or text in order and passes them on in large pieces. After the first failure it
/// takes no more.
class ByteSink {
public:
    ByteSink(const ByteSink&) = delete;
    ByteSink& operator=(const ByteSink&) = delete;
    ByteSink(ByteSink&&) = delete;
    ByteSink& operator=(ByteSink&&) = delete;

    void write(std::span<const std::byte> bytes);
    void write(std::string_view text) { write(std::as_bytes(std::span{text.data(), text.size()})); }

protected:
    ByteSink() = default;
    ~ByteSink() = default;
    void flush();
    /// Passes on all of a piece; false when that failed.
    virtual bool pass_on(std::span<const std::byte> piece) = 0;
    [[nodiscard]] bool failed() const { return failed_; }

private:
    std::string waiting_;
    bool failed_ = false;
};

/// Writes what `produce` gives the sink, whole or not at all.
Result<Done>
write_bytes(const std::filesystem::path& path, const std::function<void(ByteSink&)>& produce);

/// Writes text that is there already.
Result<Done> write_text(const std::filesystem::path& path, std::string_view text);

/// Makes every writing now under way fail, so that it leaves nothing behind. May be called by a
/// signal handler.
void cancel_writing() noexcept;
[[nodiscard]] bool writing_cancelled() noexcept;

} // namespace hs::exporting
