#include "core/export/npz.hpp"

#include "core/export/whole_file.hpp"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <utility>

namespace hs::exporting {
namespace {

namespace fs = std::filesystem;

std::string_view numpy_type(ColumnType type) {
    switch (type) {
    case ColumnType::float32: return "<f4";
    case ColumnType::uint8: return "|u1";
    case ColumnType::uint16: return "<u2";
    case ColumnType::uint32: return "<u4";
    case ColumnType::uint64: return "<u8";
    case ColumnType::int64: return "<i8";
    }
    HS_CHECK(false, "every column type has a NumPy name");
    return "";
}

/// A member while libzip reads it.
struct Reading {
    Member member;
    std::size_t position = 0;
};

zip_int64_t describe(const Reading& reading, void* out) {
    zip_stat_t stat;
    zip_stat_init(&stat);
    stat.size = reading.member.size;
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
        const std::size_t count =
            std::min<std::size_t>(length, reading.member.size - reading.position);
        reading.member.produce(reading.position, count, static_cast<std::byte*>(out));
        reading.position += count;
        return static_cast<zip_int64_t>(count);
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
        const std::array<int, 2> no_error{};
        std::memcpy(out, no_error.data(), sizeof no_error);
        return sizeof no_error;
    }
    return 0; // close and free: the members are kept by their owner
}

/// An open archive; discarded unless closed.
class Archive {
public:
    explicit Archive(const fs::path& path) {
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
        const zip_int64_t index =
            source == nullptr
                ? -1
                : zip_file_add(zip_, reading.member.name.c_str(), source, ZIP_FL_ENC_UTF_8);
        if (index < 0) {
            zip_source_free(source);
            problem_ = zip_strerror(zip_);
            return false;
        }
        const auto at = static_cast<zip_uint64_t>(index);
        // A fixed date keeps equal recordings equal files
        zip_file_set_dostime(zip_, at, 0, (1 << 5) | 1, 0);
        return zip_set_file_compression(zip_, at, ZIP_CM_STORE, 0) == 0;
    }

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

/// Bytes of `header` and then of `body`, as one sequence.
template <typename Body>
auto with_header(std::string header, Body body) {
    return [header = std::move(header),
            body = std::move(body)](std::size_t first, std::size_t count, std::byte* out) mutable {
        if (first < header.size()) {
            const std::size_t part = std::min(count, header.size() - first);
            std::memcpy(out, header.data() + first, part);
            first += part;
            count -= part;
            out += part;
        }
        if (count > 0) {
            body(first - header.size(), count, out);
        }
    };
}

/// Bytes of a column, rows produced as they are asked for; a row may be cut by the end of a
/// request.
struct ColumnBytes {
    Column column;
    std::size_t row_size = 0;
    std::vector<std::byte> row{};

    void operator()(std::size_t first, std::size_t count, std::byte* out) {
        row.resize(row_size);
        while (count > 0) {
            const std::size_t offset = first % row_size;
            column.read(first / row_size, row.data());
            const std::size_t part = std::min(count, row_size - offset);
            std::memcpy(out, row.data() + offset, part);
            first += part;
            count -= part;
            out += part;
        }
    }
};

std::vector<std::size_t> column_shape(const Column& column, std::size_t rows) {
    if (column.components == 1) {
        return {rows};
    }
    return {rows, column.components};
}

} // namespace

std::string npy_header(ColumnType type, const std::vector<std::size_t>& shape) {
    std::string dimensions;
    for (const std::size_t dimension : shape) {
        dimensions += fmt::format("{}, ", dimension);
    }
    std::string text = fmt::format(
        "{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", numpy_type(type), dimensions
    );
    // Magic, version, header length: 10 bytes; all of it a multiple of 64, ending in a newline
    constexpr std::size_t prefix = 10;
    constexpr std::size_t alignment = 64;
    const std::size_t padding = alignment - 1 - (prefix + text.size()) % alignment;
    text.append(padding, ' ');
    text += '\n';
    std::string header = "\x93NUMPY\x01";
    header += '\0';
    header += static_cast<char>(text.size() & 0xFFU);
    header += static_cast<char>(text.size() >> 8U);
    return header + text;
}

Member text_member(std::string name, std::string text) {
    const std::size_t size = text.size();
    return {
        std::move(name),
        size,
        [text = std::move(text)](std::size_t first, std::size_t count, std::byte* out) {
            std::memcpy(out, text.data() + first, count);
        }};
}

Member column_member(const Column& column, std::size_t rows) {
    const std::size_t row_size = column.components * size_of(column.type);
    std::string header = npy_header(column.type, column_shape(column, rows));
    const std::size_t size = header.size() + rows * row_size;
    return {
        column.name + ".npy",
        size,
        with_header(std::move(header), ColumnBytes{.column = column, .row_size = row_size})};
}

Member array_member(
    std::string name, ColumnType type, std::vector<std::size_t> shape, const void* values
) {
    std::size_t bytes = size_of(type);
    for (const std::size_t dimension : shape) {
        bytes *= dimension;
    }
    std::string header = npy_header(type, shape);
    const std::size_t size = header.size() + bytes;
    return {
        std::move(name),
        size,
        with_header(
            std::move(header),
            [values](std::size_t first, std::size_t count, std::byte* out) {
                std::memcpy(out, static_cast<const std::byte*>(values) + first, count);
            }
        )};
}

Result<Member> file_member(std::string name, const fs::path& file) {
    std::error_code error;
    const auto size = fs::file_size(file, error);
    auto stream = std::make_shared<std::ifstream>(file, std::ios::binary);
    if (error || !*stream) {
        return Diagnostic{.file = file.string(), .message = "cannot be read into the trace"};
    }
    return Member{
        std::move(name), size, [stream](std::size_t first, std::size_t count, std::byte* out) {
            // A file that shrank meanwhile leaves zeros; its digest in the manifest will not match
            std::memset(out, 0, count);
            stream->clear();
            stream->seekg(static_cast<std::streamoff>(first));
            std::string bytes(count, '\0');
            stream->read(bytes.data(), static_cast<std::streamsize>(count));
            std::memcpy(out, bytes.data(), static_cast<std::size_t>(stream->gcount()));
        }};
}

Result<Done> write_archive(const fs::path& path, std::vector<Member> members) {
    return write_whole(path, [&](const fs::path& temporary) -> Result<Done> {
        std::vector<Reading> readings;
        readings.reserve(members.size());
        for (const Member& member : members) {
            readings.push_back({member});
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

Result<Done> write_npz(const fs::path& path, const Table& table) {
    std::vector<Member> members;
    for (const Column& column : table.columns) {
        members.push_back(column_member(column, table.rows));
    }
    return write_archive(path, std::move(members));
}

} // namespace hs::exporting
