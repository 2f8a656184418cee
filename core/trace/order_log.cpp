#include "core/trace/order_log.hpp"

#include <algorithm>

namespace hs::trace {

void OrderLog::add(const visibility::OrderEvent& event) {
    if (events_.size() % block_size == 0) {
        blocks_.push_back(counts_);
    }
    events_.push_back(event);
    ++counts_[static_cast<std::size_t>(event.kind)];
}

OrderCounts OrderLog::counts_before(std::size_t events) const {
    HS_DCHECK(events <= size(), "at most as many as there are");
    if (events == size()) {
        return counts_;
    }
    const std::size_t block = events / block_size;
    OrderCounts counts = blocks_[block];
    for (std::size_t i = block * block_size; i < events; ++i) {
        ++counts[static_cast<std::size_t>(events_[i].kind)];
    }
    return counts;
}

std::optional<std::size_t>
OrderLog::find(visibility::OrderEventKind kind, std::uint64_t ordinal) const {
    const auto index = static_cast<std::size_t>(kind);
    if (ordinal >= counts_[index]) {
        return std::nullopt;
    }
    const auto after = std::upper_bound(
        blocks_.begin(),
        blocks_.end(),
        ordinal,
        [index](std::uint64_t wanted, const OrderCounts& before) { return wanted < before[index]; }
    );
    const auto block = static_cast<std::size_t>(after - blocks_.begin()) - 1;
    std::uint64_t left = ordinal - blocks_[block][index];
    for (std::size_t i = block * block_size;; ++i) {
        if (events_[i].kind == kind && left-- == 0) {
            return i;
        }
    }
}

} // namespace hs::trace
