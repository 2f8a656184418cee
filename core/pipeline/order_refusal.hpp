// Why a scene is not drawn as its settings ask: what has no meaning, and an ordering that would
// take too long unless it is asked for twice.
#pragma once

#include "core/pipeline/frame.hpp"

#include <optional>
#include <string>

namespace hs::pipeline {

/// One sentence, or nothing. Precondition: the vertex stage has run.
std::optional<std::string> refuse_order(const Frame& frame);

} // namespace hs::pipeline
