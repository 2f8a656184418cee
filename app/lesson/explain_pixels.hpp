// Why a pixel is covered or not, in the numbers of its three edges.
#pragma once

#include "app/lesson/grade.hpp"

#include <string>

namespace hs::lesson {

/// A line for each of the first wrongly picked and forgotten pixels of a coverage question: which
/// edge rejects it, or who owns the tie. Empty when `asked` is not of one triangle.
std::string explain_pixels(const Expression& asked, const Grade& grade, const Evaluator& evaluate);

} // namespace hs::lesson
