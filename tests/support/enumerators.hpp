// How many enumerators an enumeration has, from the names compilers give template arguments.
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>

namespace hs::tests {

/// Names the value: "…scene::Shading::flat…" for an enumerator, "…(scene::Shading)4…" else.
template <auto value>
constexpr std::string_view spelled() {
    return __PRETTY_FUNCTION__;
}

template <auto value>
constexpr bool is_enumerator() {
    constexpr std::string_view text = spelled<value>();
    constexpr std::size_t begin = text.find("value = ") + 8;
    constexpr std::string_view argument =
        text.substr(begin, text.find_first_of(";]", begin) - begin);
    // A cast ends in ")4"; the parenthesis of "(anonymous namespace)::" is followed by a colon
    constexpr std::size_t cast = argument.rfind(')');
    return cast == std::string_view::npos || argument[cast + 1] == ':';
}

/// The number of enumerators when they count from 0 without gaps, up to 64.
template <typename Enum>
constexpr std::size_t enumerator_count() {
    return []<std::size_t... i>(std::index_sequence<i...>) {
        std::size_t count = 0;
        // Stops counting at the first gap: && does not evaluate what follows it
        static_cast<void>((... && (is_enumerator<static_cast<Enum>(i)>() && ++count > 0)));
        return count;
    }
    (std::make_index_sequence<64>{});
}

} // namespace hs::tests
