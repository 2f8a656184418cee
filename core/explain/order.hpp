// The decisions of ordering algorithms in words and formulas.
#pragma once

#include "core/explain/formulas.hpp"
#include "core/trace/order_detail.hpp"
#include "core/trace/recording.hpp"

#include <string>
#include <vector>

namespace hs::explain {

/// What a polygon of the ordering is called: "triangle 3", "part 1 of triangle 3", "polygon 2" for
/// a face of several triangles; with the object where there is more than one.
std::string
polygon_name(const trace::Recording& recording, const pipeline::OrderedPolygon& polygon);
/// By the number decisions use.
std::string polygon_name(const trace::Recording& recording, std::int32_t polygon);

std::string order_sentence(const trace::Recording& recording, const trace::OrderDetail& detail);

/// How the numbers of a decision came about.
std::vector<Formula>
order_formulas(const trace::Recording& recording, const trace::OrderDetail& detail);

} // namespace hs::explain
