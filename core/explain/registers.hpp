// The registers of a traversal that moves edge values instead of evaluating them: what they hold at
// a pixel, and the addition that brought it there.
//
// Pineda, A Parallel Algorithm for Polygon Rasterization, 1988.
#pragma once

#include "core/scene/settings.hpp"
#include "core/trace/detail.hpp"
#include "core/trace/step.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace hs::explain {

/// How edge values came to a pixel.
enum class RegisterMove : std::uint8_t {
    evaluated, ///< afresh: the first pixel of all
    right,     ///< E + a
    left,      ///< E − a
    down,      ///< E + b
    next_row,  ///< row + b, and E begins there
};

/// Of one edge function, in 1/65536 pixel².
struct EdgeRegisters {
    std::int64_t row = 0;    ///< at the beginning of the row
    std::int64_t before = 0; ///< of what was added to
    std::int64_t now = 0;    ///< at the pixel
    std::int64_t a = 0;      ///< one pixel to the right adds
    std::int64_t b = 0;      ///< one pixel down adds
};

struct Registers {
    PixelPos pixel;
    PixelPos from; ///< where the value came from; the pixel itself if it was evaluated
    RegisterMove move = RegisterMove::evaluated;
    bool keeps_rows = true; ///< a second set for the beginning of the row
    std::array<EdgeRegisters, 3> edges{};
};

/// At a step of a pixel: empty unless its traversal moves values from pixel to pixel (incremental,
/// serpentine, and hierarchical within a tile).
[[nodiscard]] std::optional<Registers> registers_at(
    const trace::StepDetail& detail, const trace::Step& step, scene::TraversalKind traversal
);

/// "E01 + a01", "row01 + b01", of edge k. Precondition: it was not evaluated.
[[nodiscard]] std::string addition(const Registers& registers, unsigned k);

} // namespace hs::explain
