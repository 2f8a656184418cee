#include "core/export/table_file.hpp"

#include "core/export/npz.hpp"
#include "core/export/whole_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>
#include <iterator>

namespace hs::exporting {
namespace {

/// Room for one row of any column: four numbers of eight bytes.
using Row = std::array<std::byte, 32>;

template <typename T>
T load(const std::byte* value) {
    T result{};
    std::memcpy(&result, value, sizeof result);
    return result;
}

std::int64_t load_whole(ColumnType type, const std::byte* value) {
    switch (type) {
    case ColumnType::uint8: return load<std::uint8_t>(value);
    case ColumnType::uint16: return load<std::uint16_t>(value);
    case ColumnType::int32: return load<std::int32_t>(value);
    case ColumnType::uint32: return load<std::uint32_t>(value);
    case ColumnType::uint64: return static_cast<std::int64_t>(load<std::uint64_t>(value));
    case ColumnType::float32:
    case ColumnType::float64: break;
    }
    HS_CHECK(false, "a column of whole numbers");
    return 0;
}

/// How a format writes what is not a plain number.
struct Notation {
    std::string_view quote;      ///< around names
    std::string_view not_finite; ///< for infinities and what is not a number; "": inf, -inf, nan
};
constexpr Notation csv{"", ""};
constexpr Notation json{"\"", "null"};

template <typename Real>
void append_real(fmt::memory_buffer& text, const std::byte* value, const Notation& notation) {
    const auto number = load<Real>(value);
    if (std::isfinite(number) || notation.not_finite.empty()) {
        // The shortest text that reads back exactly
        fmt::format_to(std::back_inserter(text), "{}", number);
    } else {
        fmt::format_to(std::back_inserter(text), "{}", notation.not_finite);
    }
}

void append_number(
    fmt::memory_buffer& text, const Column& column, const std::byte* value, const Notation& notation
) {
    const auto out = std::back_inserter(text);
    if (column.type == ColumnType::float32) {
        append_real<float>(text, value, notation);
        return;
    }
    if (column.type == ColumnType::float64) {
        append_real<double>(text, value, notation);
        return;
    }
    const std::int64_t number = load_whole(column.type, value);
    if (column.meanings.empty()) {
        fmt::format_to(out, "{}", number);
    } else {
        const std::string& name = column.meanings[static_cast<std::size_t>(number)];
        fmt::format_to(out, "{}{}{}", notation.quote, name, notation.quote);
    }
}

/// The components of one row, separated by commas.
void append_row(
    fmt::memory_buffer& text, const Column& column, std::size_t row, const Notation& notation
) {
    Row numbers;
    column.read(row, numbers.data());
    for (std::size_t c = 0; c < column.components; ++c) {
        if (c > 0) {
            text.push_back(',');
        }
        append_number(text, column, numbers.data() + c * size_of(column.type), notation);
    }
}

void set_csv_line(fmt::memory_buffer& line, const Table& table, std::size_t row) {
    line.clear();
    for (const Column& column : table.columns) {
        if (line.size() > 0) {
            line.push_back(',');
        }
        append_row(line, column, row, csv);
    }
    line.push_back('\n');
}

std::string csv_header(const Table& table) {
    std::string header;
    for (const Column& column : table.columns) {
        for (std::size_t c = 0; c < column.components; ++c) {
            header += header.empty() ? "" : ",";
            header += component_name(column.name, column.components, c);
        }
    }
    return header + '\n';
}

void write_json_column(ByteSink& sink, const Column& column, std::size_t rows) {
    sink.write(fmt::format("\"{}\": [", column.name));
    fmt::memory_buffer text;
    for (std::size_t row = 0; row < rows; ++row) {
        text.clear();
        fmt::format_to(std::back_inserter(text), "{}", row == 0 ? "" : ", ");
        if (column.components > 1) {
            text.push_back('[');
        }
        append_row(text, column, row, json);
        if (column.components > 1) {
            text.push_back(']');
        }
        sink.write(std::string_view{text.data(), text.size()});
    }
    sink.write("]");
}

} // namespace

Result<Done> write_csv(const std::filesystem::path& path, const Table& table) {
    return write_bytes(path, [&table](ByteSink& sink) {
        sink.write(csv_header(table));
        fmt::memory_buffer line;
        for (std::size_t row = 0; row < table.rows; ++row) {
            set_csv_line(line, table, row);
            sink.write(std::string_view{line.data(), line.size()});
        }
    });
}

Result<Done> write_json(const std::filesystem::path& path, const Table& table) {
    return write_bytes(path, [&table](ByteSink& sink) {
        std::string_view separator = "{\n";
        for (const Column& column : table.columns) {
            sink.write(separator);
            write_json_column(sink, column, table.rows);
            separator = ",\n";
        }
        sink.write("\n}\n");
    });
}

Result<Done>
write_npz(const std::filesystem::path& path, const Table& table, const Attributes& attributes) {
    std::vector<Member> members;
    add_columns(members, table);
    members.push_back(manifest_member(attributes));
    return write_archive(path, members);
}

} // namespace hs::exporting
