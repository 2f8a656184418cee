// What to look for where two frames differ in one setting.
#pragma once

#include <string_view>

namespace hs::explain {

/// A few sentences; empty where the setting's own explanation says it all.
std::string_view effect_of_setting(std::string_view key);

} // namespace hs::explain
