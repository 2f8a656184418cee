// The names of what ordering algorithms decide, each with the sentence that explains it.
#pragma once

#include "core/base/named.hpp"
#include "core/visibility/order_trace.hpp"

#include <cstddef>

namespace hs::visibility {

inline constexpr std::size_t order_event_kind_count =
    static_cast<std::size_t>(OrderEventKind::undecided) + 1;

} // namespace hs::visibility

namespace hs {
template <>
std::span<const Named<visibility::OrderEventKind>> names<visibility::OrderEventKind>();
template <>
std::span<const Named<visibility::NewellTest>> names<visibility::NewellTest>();
template <>
std::span<const Named<visibility::Side>> names<visibility::Side>();
} // namespace hs
