// One sentence about where the playhead stands, with its numbers: the same in the window, on the
// command line and in lessons.
#pragma once

#include "core/trace/player.hpp"

#include <string>

namespace hs::explain {

/// "Fragment (31, 17) of triangle 12 fails the depth test: 0.7312 < 0.6120 is false."
std::string sentence(const trace::Player& player);

/// The symbol of a comparison: "<" for less; empty for never and always.
std::string_view symbol(scene::CompareOp op);

} // namespace hs::explain
