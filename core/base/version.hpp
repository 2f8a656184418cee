#pragma once

#include <string_view>

namespace hs {

/// The version of the program as `halfspace --version` and every saved file state it.
[[nodiscard]] std::string_view program_version();

} // namespace hs
