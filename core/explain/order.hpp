// The decisions of ordering algorithms in words and formulas.
#pragma once

#include "core/explain/formulas.hpp"
#include "core/trace/order_detail.hpp"
#include "core/trace/recording.hpp"

#include <string>
#include <vector>

namespace hs::explain {

/// What a polygon of the ordering is called: "triangle 3", "part 1 of triangle 3", "polygon 2" for
/// a face of several triangles; with the object where there is more than one, or only the object
/// where it is all there is of it: "red" in quotes.
std::string
polygon_name(const trace::Recording& recording, const pipeline::OrderedPolygon& polygon);
/// Its numbers alone: "3", object and triangle "1.3", a part "1.3/2"; a short name of an object
/// that has nothing else.
std::string
polygon_label(const trace::Recording& recording, const pipeline::OrderedPolygon& polygon);

/// About one decision of a recording.
std::string order_sentence(const trace::Recording& recording, std::uint32_t event);

/// How the numbers of a decision came about.
std::vector<Formula>
order_formulas(const trace::Recording& recording, const trace::OrderDetail& detail);

} // namespace hs::explain
