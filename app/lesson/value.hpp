// What an expression over the trace yields, and what a student answers.
#pragma once

#include "core/base/pixel.hpp"

#include <string>
#include <variant>
#include <vector>

namespace hs::lesson {

/// Sorted by row, then column; no pixel twice.
using PixelSet = std::vector<PixelPos>;

/// A number, yes or no, a name (a fate, a verdict), or a set of pixels.
using Value = std::variant<double, bool, std::string, PixelSet>;

/// Sorts and removes doubles.
PixelSet make_pixel_set(std::vector<PixelPos> pixels);

/// As narration prints it: numbers with `digits` places after the point, or with as many as they
/// need (at most 6) when `digits` is negative; "yes" and "no"; pixels as "(3, 4) (4, 4)".
std::string print_value(const Value& value, int digits = -1);

} // namespace hs::lesson
