// Results for people and for programs.
#pragma once

#include "app/bench/measurement.hpp"

#include <string>

namespace hs::bench {

/// One line per measurement: value, peer, ratio, budget, whether it holds; remarks below.
std::string to_table(const Results& results);

/// `{"machine": …, "results": […], "remarks": […]}`. A result's budget is of its ratio where a peer
/// is named, else of its value; what does not exist is left out.
std::string to_json(const Results& results);

} // namespace hs::bench
