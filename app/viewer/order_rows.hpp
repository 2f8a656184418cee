// What the order panel's lists are made of: rows that name a polygon and say where it stands.
#pragma once

#include "app/viewer/panels.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace hs::viewer {

/// A polygon of a decision, and whether it goes first; nothing where that was not asked.
struct DecidedPolygon {
    std::int32_t index = -1; ///< −1: no one
    std::optional<bool> first;
};
struct DecidedPair {
    DecidedPolygon first;  ///< `polygon` of the decision
    DecidedPolygon second; ///< `other`
};
[[nodiscard]] DecidedPair decided_pair(const visibility::OrderEvent& decision);

/// ▲ and ▼ have colors of their own, everything else that is looked at has the accent's.
[[nodiscard]] Tone tone_of(const std::optional<bool>& first);

/// Whether the playhead stands on a decision, not behind all of them.
[[nodiscard]] bool stands_on_decision(const Context& context);

/// What a polygon is called, in words.
[[nodiscard]] std::string
full_name(const Context& context, const trace::OrderDetail& detail, std::int32_t polygon);

/// Its numbers alone, for lists and trees.
[[nodiscard]] std::string
label_of(const Context& context, const trace::OrderDetail& detail, std::int32_t polygon);

/// Of a list.
struct OrderRow {
    std::int32_t polygon = -1; ///< −1: an empty row
    std::string text;          ///< at the right: what the list sorts by
    std::string middle{};      ///< of three columns
    Tone tone = Tone::text;
    std::optional<Tone> lit{};   ///< what the current decision looks at
    std::optional<bool> first{}; ///< marked ▲ or ▼
};
/// One row at the cursor, `width` wide; a click goes to the polygon's triangle.
void draw_order_row(
    Context& context, const trace::OrderDetail& detail, const OrderRow& row, float width
);

/// Lights a row that the decision is about.
void light(OrderRow& row, const DecidedPair& pair);
/// Lights a row whose triangle is being drawn.
void light_drawn(const Context& context, const trace::OrderDetail& detail, OrderRow& row);

/// The rows [first, last) of `count` to show around `focus`: long lists are cut.
struct RowRange {
    int first = 0;
    int last = 0;
};
[[nodiscard]] RowRange rows_around(int focus, int count);

} // namespace hs::viewer
