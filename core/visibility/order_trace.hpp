// How an ordering algorithm tells its story: one event per decision, and the state after it.
#pragma once

#include <concepts>
#include <cstdint>

namespace hs::visibility {

/// A decision. What the numbers mean is said beside each kind.
enum class OrderEventKind : std::uint8_t {
    compare, ///< is the key of `polygon` (`value`) before that of `other` (`other_value`)?
    move,    ///< `polygon` goes to place `place` of the list
    emit,    ///< `polygon` is drawn next
};

/// One step of an ordering algorithm.
struct OrderEvent {
    OrderEventKind kind = OrderEventKind::compare;
    bool verdict = false;      ///< the question's answer, where the kind asks one
    std::int32_t polygon = -1; ///< index into the state's polygons
    std::int32_t other = -1;
    std::int32_t place = -1;
    double value = 0.0;
    double other_value = 0.0;
};

/// Takes a story; never steers. `State` is the algorithm's own (its polygons, lists, tree), as it
/// is after the event.
template <typename Sink, typename State>
concept OrderSink = requires(Sink sink, const OrderEvent& event, const State& state) {
    { sink.order_step(event, state) } -> std::same_as<void>;
};

/// Listens to nothing.
struct SilentOrder {
    template <typename State>
    void order_step(const OrderEvent&, const State&) {}
};

} // namespace hs::visibility
