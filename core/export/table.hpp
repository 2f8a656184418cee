// Tables: named columns of plain numbers, produced a row at a time, so that a table of millions of
// rows is never held twice.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/trace/player.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hs::exporting {

/// What a column's numbers are, as NumPy names them.
enum class ColumnType : std::uint8_t {
    float32,
    float64,
    uint8,
    uint16,
    int32,
    uint32,
    uint64
};

/// Bytes of one number.
[[nodiscard]] std::size_t size_of(ColumnType type);

struct Column {
    std::string name; ///< "vertex.clip"
    ColumnType type = ColumnType::float32;
    std::size_t components = 1; ///< numbers per row, at most 4
    /// What the numbers of a column stand for when they are enumerators, by value; else empty.
    std::vector<std::string> meanings;
    /// Writes `components` numbers of row `row` to `out`. Fast for rows in order.
    std::function<void(std::size_t row, void* out)> read;
};

/// "vertex.clip" to "vertex.clip.y"; colors have .r .g .b .a, weights and corners .0 .1 .2.
[[nodiscard]] std::string
component_name(std::string_view column, std::size_t components, std::size_t component);

struct Table {
    std::string name;
    std::size_t rows = 0;
    std::vector<Column> columns;
};

/// A table `make_table` knows, with one sentence.
struct TableName {
    std::string_view name;
    std::string_view explanation;
};
std::span<const TableName> table_names();

/// A table at the player's step, columns as in the trace format; it keeps the recording alive.
/// What is per vertex and per triangle is of the whole frame; fragments, runs, decisions
/// and counters go up to the step. Anything else than the names above is an error that lists them.
Result<Table> make_table(const trace::Player& player, std::string_view name);

/// The tables of a whole frame, as a trace keeps them.
std::vector<Table> trace_tables(const std::shared_ptr<const trace::Recording>& recording);

} // namespace hs::exporting
