#include "core/export/npz.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

namespace hs::exporting {
namespace {

static_assert(
    std::endian::native == std::endian::little, "arrays are written as they are in memory"
);

std::string_view numpy_type(ColumnType type) {
    switch (type) {
    case ColumnType::float32: return "<f4";
    case ColumnType::float64: return "<f8";
    case ColumnType::uint8: return "|u1";
    case ColumnType::uint16: return "<u2";
    case ColumnType::int32: return "<i4";
    case ColumnType::uint32: return "<u4";
    case ColumnType::uint64: return "<u8";
    }
    HS_CHECK(false, "every column type has a NumPy name");
    return "";
}

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
    return column.components == 1 ? std::vector{rows} : std::vector{rows, column.components};
}

} // namespace

std::string npy_header(std::string_view type, const std::vector<std::size_t>& shape) {
    std::string dimensions;
    for (const std::size_t dimension : shape) {
        dimensions += fmt::format("{}, ", dimension);
    }
    std::string text =
        fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, dimensions);
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
    std::string header = npy_header(numpy_type(column.type), column_shape(column, rows));
    const std::size_t size = header.size() + rows * row_size;
    return {
        column.name + ".npy",
        size,
        with_header(std::move(header), ColumnBytes{.column = column, .row_size = row_size})};
}

Member texts_member(const std::string& name, std::span<const std::string> texts) {
    std::size_t longest = 1;
    for (const std::string& text : texts) {
        longest = std::max(longest, text.size());
    }
    // Four bytes a letter, short texts filled up with zeros
    std::string bytes = npy_header(fmt::format("<U{}", longest), {texts.size()});
    for (const std::string& text : texts) {
        for (std::size_t i = 0; i < longest; ++i) {
            bytes += i < text.size() ? text[i] : '\0';
            bytes.append(3, '\0');
        }
    }
    return text_member(name + ".npy", std::move(bytes));
}

Member array_member(
    const std::string& name,
    ColumnType type,
    const std::vector<std::size_t>& shape,
    const void* values
) {
    std::size_t bytes = size_of(type);
    for (const std::size_t dimension : shape) {
        bytes *= dimension;
    }
    std::string header = npy_header(numpy_type(type), shape);
    const std::size_t size = header.size() + bytes;
    return {
        name + ".npy",
        size,
        with_header(
            std::move(header),
            [values](std::size_t first, std::size_t count, std::byte* out) {
                std::memcpy(out, static_cast<const std::byte*>(values) + first, count);
            }
        )};
}

Member manifest_member(const Attributes& attributes) {
    nlohmann::ordered_json manifest;
    for (const auto& [name, text] : attributes) {
        manifest[name] = text;
    }
    return text_member("manifest.json", manifest.dump(2) + '\n');
}

void add_columns(std::vector<Member>& members, const Table& table) {
    for (const Column& column : table.columns) {
        members.push_back(column_member(column, table.rows));
        if (!column.meanings.empty()) {
            members.push_back(texts_member(column.name + ".names", column.meanings));
        }
    }
}

} // namespace hs::exporting
