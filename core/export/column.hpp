// Columns from functions: how the tables are put together.
#pragma once

#include "core/base/named.hpp"
#include "core/export/table.hpp"
#include "core/trace/outline.hpp"

#include <array>
#include <cstring>
#include <type_traits>
#include <utility>

namespace hs::exporting {

using SharedRecording = std::shared_ptr<const trace::Recording>;

template <typename T>
constexpr ColumnType type_of() {
    if constexpr (std::is_same_v<T, float>) {
        return ColumnType::float32;
    } else if constexpr (std::is_same_v<T, double>) {
        return ColumnType::float64;
    } else if constexpr (std::is_same_v<T, std::int32_t>) {
        return ColumnType::int32;
    } else if constexpr (std::is_same_v<T, std::uint8_t>) {
        return ColumnType::uint8;
    } else if constexpr (std::is_same_v<T, std::uint16_t>) {
        return ColumnType::uint16;
    } else if constexpr (std::is_same_v<T, std::uint32_t>) {
        return ColumnType::uint32;
    } else {
        static_assert(std::is_same_v<T, std::uint64_t>);
        return ColumnType::uint64;
    }
}

/// A column of N numbers of type T per row; `get(row)` returns them as an array.
template <typename T, std::size_t N, typename Get>
// NOLINTNEXTLINE(performance-unnecessary-value-param): the name is moved, which is not seen here
Column column(std::string name, Get get) {
    return {
        .name = std::move(name),
        .type = type_of<T>(),
        .components = N,
        .meanings = {},
        .read = [get = std::move(get)](std::size_t row, void* out) mutable {
            const std::array<T, N> values = get(row);
            std::memcpy(out, values.data(), sizeof values);
        }};
}

/// A column of one number per row.
template <typename T, typename Get>
Column column(std::string name, Get get) {
    return column<T, 1>(std::move(name), [get = std::move(get)](std::size_t row) mutable {
        return std::array<T, 1>{get(row)};
    });
}

/// A column of enumerators, which brings their names.
template <typename Enum, typename Get>
Column named_column(std::string name, Get get) {
    Column result =
        column<std::uint8_t>(std::move(name), [get = std::move(get)](std::size_t row) mutable {
            return static_cast<std::uint8_t>(get(row));
        });
    for (const Named<Enum>& row : names<Enum>()) {
        result.meanings.emplace_back(row.name);
    }
    return result;
}

template <typename Space>
std::array<float, 4> as_array(const math::Position<Space>& p) {
    return {p.x, p.y, p.z, p.w};
}

/// Addresses of steps, remembering the stretch around the last one asked for: quick in order.
class StepAddresses {
public:
    explicit StepAddresses(SharedRecording recording) : recording_(std::move(recording)) {}
    /// Valid until the next call. Precondition: the step exists.
    const trace::Step& operator()(trace::StepId step);

private:
    SharedRecording recording_;
    trace::Outline stretch_;
    trace::Step alone_; ///< of a step outside all stretches
};

// The tables, each in a file of its own
Table vertex_table(const SharedRecording& recording);
Table triangle_table(const SharedRecording& recording);
/// The first `fragments` fragments.
Table fragment_table(const SharedRecording& recording, std::uint32_t fragments);
/// The runs these fragments belong to.
Table run_table(const SharedRecording& recording, std::uint32_t fragments);
/// Every step up to and including `last`.
Table step_table(const SharedRecording& recording, trace::StepId last);
/// The first `decisions` decisions of the ordering algorithm.
Table order_table(const SharedRecording& recording, std::size_t decisions);
Table span_table(const SharedRecording& recording);
Table ray_table(const SharedRecording& recording);
Table sweep_table(const trace::Player& player);
Table counter_table(const trace::Counters& counters);
/// Of the triangle the player stands on, else of the frame.
Table traversal_table(const trace::Player& player);
/// What the samples hold at the step; empty with one sample a pixel.
Table sample_table(const trace::Player& player);

/// Polygons made by clipping.
struct PieceTables {
    Table pieces;
    Table vertices;
};
PieceTables piece_tables(const SharedRecording& recording);

} // namespace hs::exporting
