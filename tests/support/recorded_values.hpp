// What the pipeline recorded, or told a re-run, about a step: the oracle of explanations.
#pragma once

#include "core/explain/term.hpp"
#include "core/trace/recording.hpp"

#include <string>
#include <utility>
#include <vector>

namespace hs::tests {

/// The values of a step that the pipeline itself has, by the names explanations give them.
std::vector<std::pair<std::string, explain::Number>>
recorded_values(const trace::Recording& recording, const trace::Step& step);

} // namespace hs::tests
