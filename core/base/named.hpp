// One table per enumeration: the name in files, and one sentence that explains it. Panels print
// from these tables, scene files are parsed with them, lessons quote them, and a test checks that
// no enumerator is missing.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace hs {

template <typename Enum>
struct Named {
    Enum value;
    std::string_view name;        ///< as written in files and on the command line
    std::string_view explanation; ///< one sentence, without a final full stop
};

/// Specialized next to every enumeration: `template <> std::span<const Named<Shading>>
/// names<Shading>();`
template <typename Enum>
std::span<const Named<Enum>> names();

/// The row of an enumerator. Tables list enumerators in order, so this is an index.
template <typename Enum>
const Named<Enum>& named(Enum value) {
    return names<Enum>()[static_cast<std::size_t>(value)];
}

template <typename Enum>
std::string_view name_of(Enum value) {
    return named(value).name;
}

template <typename Enum>
std::optional<Enum> parse_name(std::string_view text) {
    for (const Named<Enum>& row : names<Enum>()) {
        if (row.name == text) {
            return row.value;
        }
    }
    return std::nullopt;
}

} // namespace hs
