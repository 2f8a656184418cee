// Zip archives through libzip: members are stored, and produced while they are written.
#include "core/export/npz.hpp"
#include "core/export/whole_file.hpp"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <exception>

namespace hs::exporting {
namespace {

/// A member while libzip reads it.
struct Reading {
    const Member* member = nullptr;
    std::size_t position = 0;
    std::array<int, 2> error{}; ///< libzip's code and the system's
};

/// Bytes for libzip, −1 when there are none to be had. Exceptions must not reach its C code.
zip_int64_t read(Reading& reading, void* out, zip_uint64_t length) noexcept {
    if (writing_cancelled()) {
        reading.error = {ZIP_ER_READ, ECANCELED};
        return -1;
    }
    const std::size_t left = reading.member->size - reading.position;
    const std::size_t count = std::min<std::size_t>(length, left);
    try {
        reading.member->produce(reading.position, count, static_cast<std::byte*>(out));
    } catch (const std::exception&) {
        reading.error = {ZIP_ER_MEMORY, 0};
        return -1;
    }
    reading.position += count;
    return static_cast<zip_int64_t>(count);
}

zip_int64_t describe(const Reading& reading, void* out) {
    zip_stat_t stat;
    zip_stat_init(&stat);
    stat.size = reading.member->size;
    stat.valid = ZIP_STAT_SIZE;
    std::memcpy(out, &stat, sizeof stat);
    return sizeof stat;
}

/// libzip asks a source for its size and its bytes through this.
zip_int64_t serve(void* state, void* out, zip_uint64_t length, zip_source_cmd_t command) {
    auto& reading = *static_cast<Reading*>(state);
    if (command == ZIP_SOURCE_OPEN) {
        reading.position = 0;
        return 0;
    }
    if (command == ZIP_SOURCE_READ) {
        return read(reading, out, length);
    }
    if (command == ZIP_SOURCE_STAT) {
        return describe(reading, out);
    }
    if (command == ZIP_SOURCE_SUPPORTS) {
        return zip_source_make_command_bitmap(
            ZIP_SOURCE_OPEN,
            ZIP_SOURCE_READ,
            ZIP_SOURCE_CLOSE,
            ZIP_SOURCE_STAT,
            ZIP_SOURCE_ERROR,
            -1
        );
    }
    if (command == ZIP_SOURCE_ERROR) {
        std::memcpy(out, reading.error.data(), sizeof reading.error);
        return sizeof reading.error;
    }
    return 0; // close and free: the members are kept by their owner
}

/// An open archive; discarded unless closed.
class Archive {
public:
    explicit Archive(const std::filesystem::path& path) {
        int code = 0;
        zip_ = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
        if (zip_ == nullptr) {
            zip_error_t error;
            zip_error_init_with_code(&error, code);
            problem_ = zip_error_strerror(&error);
            zip_error_fini(&error);
        }
    }
    Archive(const Archive&) = delete;
    Archive& operator=(const Archive&) = delete;
    Archive(Archive&&) = delete;
    Archive& operator=(Archive&&) = delete;
    ~Archive() {
        if (zip_ != nullptr) {
            zip_discard(zip_);
        }
    }

    bool add(Reading& reading) {
        if (zip_ == nullptr) {
            return false;
        }
        zip_source_t* source = zip_source_function(zip_, serve, &reading);
        const char* const name = reading.member->name.c_str();
        const zip_int64_t index =
            source == nullptr ? -1 : zip_file_add(zip_, name, source, ZIP_FL_ENC_UTF_8);
        if (index < 0) {
            zip_source_free(source);
            problem_ = zip_strerror(zip_);
            return false;
        }
        const auto at = static_cast<zip_uint64_t>(index);
        constexpr zip_uint16_t first_of_january_1980 =
            (1 << 5) | 1; // equal recordings, equal files
        zip_file_set_dostime(zip_, at, 0, first_of_january_1980, 0);
        return zip_set_file_compression(zip_, at, ZIP_CM_STORE, 0) == 0;
    }

    /// Writes everything.
    bool close() {
        if (zip_ == nullptr) {
            return false;
        }
        if (zip_close(zip_) != 0) {
            problem_ = zip_strerror(zip_);
            return false;
        }
        zip_ = nullptr;
        return true;
    }

    [[nodiscard]] const std::string& problem() const { return problem_; }

private:
    zip_t* zip_ = nullptr;
    std::string problem_;
};

} // namespace

Result<Done> write_archive(const std::filesystem::path& path, const std::vector<Member>& members) {
    return write_whole(path, [&](const std::filesystem::path& temporary) -> Result<Done> {
        std::vector<Reading> readings;
        readings.reserve(members.size());
        for (const Member& member : members) {
            readings.push_back({.member = &member});
        }
        Archive archive(temporary);
        bool good = true;
        for (Reading& reading : readings) {
            good = good && archive.add(reading);
        }
        if (!good || !archive.close()) {
            return Diagnostic{
                .file = path.string(),
                .message = fmt::format("cannot be written: {}", archive.problem())};
        }
        return done;
    });
}

} // namespace hs::exporting
