// The closed list of fates: what can become of a fragment.
#pragma once

#include "core/base/named.hpp"

#include <cstdint>

namespace hs::fragment {

enum class FragmentFate : std::uint8_t {
    written,
    scissor_failed,
    depth_failed,
    pixel_closed
};
inline constexpr int fate_count = 4;

} // namespace hs::fragment

namespace hs {
template <>
std::span<const Named<fragment::FragmentFate>> names<fragment::FragmentFate>();
} // namespace hs
