// Tables as CSV and JSON.
#include "core/export/table.hpp"
#include "core/export/whole_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstring>

namespace hs::exporting {
namespace {

/// Room for one row of any column.
using Row = std::array<std::byte, 256>;

template <typename T>
T load(const void* value) {
    T result{};
    std::memcpy(&result, value, sizeof result);
    return result;
}

/// "vertex.clip" with four components: vertex.clip.x, .y, .z, .w; with more: .0, .1 …
std::string component_name(const Column& column, std::size_t component) {
    constexpr std::string_view letters = "xyzw";
    if (column.components == 1) {
        return column.name;
    }
    return column.components <= letters.size()
               ? fmt::format("{}.{}", column.name, letters[component])
               : fmt::format("{}.{}", column.name, component);
}

std::uint64_t load_unsigned(ColumnType type, const void* value) {
    switch (type) {
    case ColumnType::uint8: return load<std::uint8_t>(value);
    case ColumnType::uint16: return load<std::uint16_t>(value);
    case ColumnType::uint32: return load<std::uint32_t>(value);
    case ColumnType::uint64: return load<std::uint64_t>(value);
    case ColumnType::float32:
    case ColumnType::int64: break;
    }
    HS_CHECK(false, "an unsigned column");
    return 0;
}

nlohmann::json number_json(const Column& column, const void* value) {
    if (column.type == ColumnType::float32) {
        const auto number = load<float>(value);
        return std::isfinite(number) ? nlohmann::json(number) : nlohmann::json(nullptr);
    }
    if (column.type == ColumnType::int64) {
        return load<std::int64_t>(value);
    }
    if (!column.meanings.empty()) {
        return number_text(column, value);
    }
    return load_unsigned(column.type, value);
}

} // namespace

std::string number_text(const Column& column, const void* value) {
    if (column.type == ColumnType::float32) {
        return fmt::format("{}", load<float>(value)); // the shortest text that reads back exactly
    }
    if (column.type == ColumnType::int64) {
        return fmt::format("{}", load<std::int64_t>(value));
    }
    const std::uint64_t number = load_unsigned(column.type, value);
    return number < column.meanings.size() ? column.meanings[number] : fmt::format("{}", number);
}

Result<Done> write_csv(const std::filesystem::path& path, const Table& table) {
    std::string text;
    for (const Column& column : table.columns) {
        for (std::size_t c = 0; c < column.components; ++c) {
            text += (text.empty() ? "" : ",") + component_name(column, c);
        }
    }
    text += '\n';
    Row numbers;
    for (std::size_t row = 0; row < table.rows; ++row) {
        const char* separator = "";
        for (const Column& column : table.columns) {
            column.read(row, numbers.data());
            for (std::size_t c = 0; c < column.components; ++c) {
                text += separator;
                text += number_text(column, numbers.data() + c * size_of(column.type));
                separator = ",";
            }
        }
        text += '\n';
    }
    return write_text(path, text);
}

Result<Done> write_json(const std::filesystem::path& path, const Table& table) {
    nlohmann::ordered_json document;
    Row numbers;
    for (const Column& column : table.columns) {
        nlohmann::json values = nlohmann::json::array();
        for (std::size_t row = 0; row < table.rows; ++row) {
            column.read(row, numbers.data());
            nlohmann::json entry = nlohmann::json::array();
            for (std::size_t c = 0; c < column.components; ++c) {
                entry.push_back(number_json(column, numbers.data() + c * size_of(column.type)));
            }
            values.push_back(column.components == 1 ? entry.front() : entry);
        }
        document[column.name] = std::move(values);
    }
    return write_text(path, document.dump() + '\n');
}

} // namespace hs::exporting
