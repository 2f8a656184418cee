// What a quantity is read of: an object, a vertex, a triangle, a pixel, written as in step paths.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/base/pixel.hpp"
#include "core/trace/recording.hpp"
#include "core/trace/step.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hs::lesson {

/// Parts of a path, as far as they were written. Numbers are those of step paths: vertices and
/// triangles count per object.
struct Subject {
    std::optional<std::uint32_t> object;
    std::optional<std::uint32_t> vertex;
    std::optional<std::uint32_t> triangle;
    std::optional<std::uint32_t> piece;
    std::optional<PixelPos> pixel;
};

/// "object 0 / triangle 2 piece 1 / pixel 5,6", parts in any order; "" and "frame" are the whole
/// frame. Errors say which part is not understood.
Result<Subject> parse_subject(std::string_view text);

/// The parts a step stands on.
Subject subject_of(const trace::Step& step);

/// What is wrong with the numbers of a subject: no such object, vertex, triangle, pixel.
std::optional<std::string> find_missing(const Subject& subject, const trace::Recording& recording);

} // namespace hs::lesson
