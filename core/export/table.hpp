// Tables: named columns of plain numbers, produced a row at a time, so that a table of millions of
// rows is never held twice.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/trace/player.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace hs::exporting {

/// What a column's numbers are, as NumPy names them.
enum class ColumnType : std::uint8_t {
    float32,
    uint8,
    uint16,
    uint32,
    uint64,
    int64
};

/// Bytes of one number.
[[nodiscard]] std::size_t size_of(ColumnType type);

struct Column {
    std::string name; ///< "vertex.clip"
    ColumnType type = ColumnType::float32;
    std::size_t components = 1; ///< numbers per row
    /// What the numbers of a column stand for when they are enumerators, by value; else empty.
    std::vector<std::string> meanings;
    /// Writes `components` numbers of row `row` to `out`, which has room and alignment for them.
    std::function<void(std::size_t row, void* out)> read;
};

struct Table {
    std::string name;
    std::size_t rows = 0;
    std::vector<Column> columns;
};

/// The tables a recording has, columns as in the trace format: "vertices", "triangles",
/// "fragments", "runs", "counters" (one row), "pieces", "piece-vertices". They keep the recording
/// alive. Anything else is an error that lists them.
Result<Table>
make_table(const std::shared_ptr<const trace::Recording>& recording, std::string_view name);

/// One row per line, components as name.0, name.1 or name.x …; enumerators by name.
Result<Done> write_csv(const std::filesystem::path& path, const Table& table);

/// {"name": [ … ], …}: a list per column, components as lists, not-a-number as null.
Result<Done> write_json(const std::filesystem::path& path, const Table& table);

/// A zip of .npy members, one per column; `numpy.load` opens it.
Result<Done> write_npz(const std::filesystem::path& path, const Table& table);

/// A column's number as text: enumerators by name, floats so that they read back exactly.
std::string number_text(const Column& column, const void* value);

} // namespace hs::exporting
