// How numbers are written: the same quantity with the same digits everywhere, the sign's column
// kept, whole numbers never with an exponent.
#pragma once

#include "core/base/pixel.hpp"

#include <glm/vec4.hpp>

#include <cstdint>
#include <string>
#include <utility>

namespace hs::explain {

/// Coordinates, weights, depths and colors: four digits after the point, without a sign's column.
/// What four digits cannot tell from 0 gets an exponent.
std::string number(float value);

/// The same with a column for the sign, so that columns of numbers stand still.
std::string signed_number(float value);

/// Two numbers that are compared: with more digits where four would show different values alike.
std::pair<std::string, std::string> compared(float left, float right);

/// Digits in groups of three: "1 048 576".
std::string whole(std::int64_t value);

/// Edge values and doubled areas in pixel², from the 1/65536 pixel² they are kept in: "16.0000".
std::string square_pixels(std::int64_t value);

/// Differences of snapped coordinates in pixels, from the 1/256 pixel they are kept in.
std::string pixels(std::int64_t value);

/// "(31, 17)"; pixels count from the top-left one.
std::string pixel(PixelPos p);

/// "(0.5000, 1.0000, 0.0000)"
std::string point(float x, float y, float z);
std::string point(const glm::vec4& v);

} // namespace hs::explain
