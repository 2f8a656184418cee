// Every decision of the ordering algorithm up to a step.
#include "core/export/column.hpp"

namespace hs::exporting {
namespace {

/// Over the whole frame, −1 for no one.
std::int32_t triangle_of(const trace::Recording& recording, std::int32_t polygon) {
    const auto& polygons = recording.order.polygons;
    return polygon < 0
               ? -1
               : static_cast<std::int32_t>(polygons[static_cast<std::size_t>(polygon)].triangle);
}

} // namespace

Table order_table(const SharedRecording& recording, std::size_t decisions) {
    using visibility::OrderEvent;
    Table table{.name = "order", .rows = decisions, .columns = {}};
    const auto number = [&table, recording](const char* name, auto get) {
        table.columns.push_back(column<std::int32_t>(
            std::string{"order."} + name,
            [recording, get](std::size_t row) -> std::int32_t {
                return get(*recording, recording->decisions[row]);
            }
        ));
    };
    const auto value = [&table, recording](const char* name, double OrderEvent::*member) {
        table.columns.push_back(column<double>(
            std::string{"order."} + name,
            [recording, member](std::size_t row) { return recording->decisions[row].*member; }
        ));
    };
    table.columns.push_back(column<std::uint64_t>("order.step", [recording](std::size_t row) {
        return recording->first_order_step + row;
    }));
    table.columns.push_back(named_column<visibility::OrderEventKind>(
        "order.decision", [recording](std::size_t row) { return recording->decisions[row].kind; }
    ));
    number("polygon", [](const auto&, const OrderEvent& event) { return event.polygon; });
    number("other", [](const auto&, const OrderEvent& event) { return event.other; });
    number("triangle", [](const auto& of, const OrderEvent& event) {
        return triangle_of(of, event.polygon);
    });
    number("other_triangle", [](const auto& of, const OrderEvent& event) {
        return triangle_of(of, event.other);
    });
    number("node", [](const auto&, const OrderEvent& event) { return event.node; });
    number("place", [](const auto&, const OrderEvent& event) { return event.place; });
    table.columns.push_back(column<std::uint8_t>("order.verdict", [recording](std::size_t row) {
        return static_cast<std::uint8_t>(recording->decisions[row].verdict ? 1 : 0);
    }));
    table.columns.push_back(named_column<visibility::Side>(
        "order.side", [recording](std::size_t row) { return recording->decisions[row].side; }
    ));
    value("value", &OrderEvent::value);
    value("other_value", &OrderEvent::other_value);
    return table;
}

} // namespace hs::exporting
