// The decisions of an ordering algorithm, in the order they were made.
#pragma once

#include "core/trace/chunked.hpp"
#include "core/visibility/order_names.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace hs::trace {

/// How many decisions of each kind.
using OrderCounts = std::array<std::uint64_t, visibility::order_event_kind_count>;

class OrderLog {
public:
    void add(const visibility::OrderEvent& event);

    [[nodiscard]] std::size_t size() const { return events_.size(); }
    [[nodiscard]] const visibility::OrderEvent& operator[](std::size_t i) const {
        return events_[i];
    }
    /// Of the first `events` decisions; a short walk, however long the log is.
    [[nodiscard]] OrderCounts counts_before(std::size_t events) const;
    /// The decision of a kind that `ordinal` ones of that kind came before.
    [[nodiscard]] std::optional<std::size_t>
    find(visibility::OrderEventKind kind, std::uint64_t ordinal) const;
    [[nodiscard]] std::size_t bytes() const {
        return events_.bytes() + blocks_.capacity() * sizeof(OrderCounts);
    }

private:
    static constexpr std::size_t block_size = 1024; ///< decisions

    Chunked<visibility::OrderEvent> events_;
    std::vector<OrderCounts> blocks_; ///< the counts before each block
    OrderCounts counts_{};
};

} // namespace hs::trace
