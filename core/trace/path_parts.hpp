// The parts of a written step path: words and numbers, as far as they were written.
#pragma once

#include "core/trace/step.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace hs::trace {

/// The parts of a path, as far as they were written.
struct PathParts {
    std::optional<std::uint32_t> object;
    std::optional<std::uint32_t> vertex;
    std::optional<std::uint32_t> triangle;
    std::optional<std::uint32_t> line;
    std::optional<std::uint32_t> point;
    std::optional<std::uint32_t> piece;
    std::optional<geometry::ClipPlane> plane;
    std::optional<PixelPos> tile;
    std::optional<int> tile_size;
    std::optional<int> scanline;
    std::optional<PixelPos> visit;
    std::optional<PixelPos> fragment;
    std::optional<int> sample;
    std::optional<StepKind> operation;
    std::optional<visibility::OrderEventKind> decision;
    std::optional<visibility::SweepEventKind> sweep;
    std::optional<std::uint64_t> ordinal; ///< among decisions of its kind
    bool vertex_stage = false;
    bool ordering = false;
};

/// Reads one part into `parts`; false when it is not understood.
bool parse_part(std::string_view part, PathParts& parts);

/// Whole text, decimal.
std::optional<StepId> parse_step_number(std::string_view text);

/// Without spaces and tabs around it.
std::string_view trimmed(std::string_view text);

} // namespace hs::trace
