#include "core/trace/path_parts.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace hs::trace {
namespace {

template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) {
        return std::nullopt;
    }
    return number;
}

std::optional<PixelPos> parse_pixel(std::string_view text) {
    const auto comma = text.find(',');
    if (comma == std::string_view::npos) {
        return std::nullopt;
    }
    const auto x = parse_number<int>(trimmed(text.substr(0, comma)));
    const auto y = parse_number<int>(trimmed(text.substr(comma + 1)));
    return x && y ? std::optional{PixelPos{*x, *y}} : std::nullopt;
}

std::optional<StepKind> parse_operation(std::string_view text) {
    return parse_name<StepKind>(text);
}

/// "triangle 12 piece 1" to triangle and piece.
bool parse_triangle(std::string_view rest, PathParts& parts) {
    const auto piece = rest.find("piece");
    parts.triangle = parse_number<std::uint32_t>(trimmed(rest.substr(0, piece)));
    if (piece != std::string_view::npos) {
        parts.piece = parse_number<std::uint32_t>(trimmed(rest.substr(piece + 5)));
    }
    return parts.triangle && (parts.piece || piece == std::string_view::npos);
}

/// "tile 8,0 size 4" to tile and size; without a size, the smallest tile there.
bool parse_tile(std::string_view rest, PathParts& parts) {
    const auto size = rest.find("size");
    parts.tile = parse_pixel(trimmed(rest.substr(0, size)));
    if (size != std::string_view::npos) {
        parts.tile_size = parse_number<int>(trimmed(rest.substr(size + 4)));
    }
    return parts.tile && (parts.tile_size || size == std::string_view::npos);
}

/// "comparison 17": the words of a decision and how many came before it. Which algorithm's it is,
/// the frame tells. Those of a sweep may stand without a number.
bool parse_decision(std::string_view part, PathParts& parts) {
    const std::size_t space = std::min(part.rfind(' '), part.size());
    const auto ordinal = parse_number<std::uint64_t>(part.substr(std::min(space + 1, part.size())));
    const std::string_view words = ordinal ? trimmed(part.substr(0, space)) : part;
    const auto decision = ordinal ? parse_name<visibility::OrderEventKind>(words) : std::nullopt;
    const auto sweep = parse_name<visibility::SweepEventKind>(words);
    if (!decision && !sweep) {
        return false;
    }
    parts.decision = decision;
    parts.sweep = sweep;
    parts.ordinal = ordinal;
    parts.operation = ordinal ? std::nullopt : parse_operation(words); // "span" is both
    return true;
}

} // namespace

bool parse_part(std::string_view part, PathParts& parts) {
    if (part == "vertex stage") {
        parts.vertex_stage = true;
        return true;
    }
    if (part == "visibility") {
        parts.ordering = true;
        return true;
    }
    if (parse_decision(part, parts)) {
        return true;
    }
    if (const auto operation = parse_operation(part)) {
        parts.operation = operation;
        return true;
    }
    const auto space = part.find(' ');
    if (space == std::string_view::npos) {
        return false;
    }
    const std::string_view word = part.substr(0, space);
    const std::string_view rest = trimmed(part.substr(space));
    if (word == "triangle") {
        return parse_triangle(rest, parts);
    }
    if (word == "tile") {
        return parse_tile(rest, parts);
    }
    if (word == "scanline") {
        return (parts.scanline = parse_number<int>(rest)).has_value();
    }
    if (word == "sample") {
        return (parts.sample = parse_number<int>(rest)).has_value();
    }
    if (word == "plane") {
        return (parts.plane = parse_name<geometry::ClipPlane>(rest)).has_value();
    }
    if (word == "pixel") {
        return (parts.visit = parse_pixel(rest)).has_value();
    }
    if (word == "fragment") {
        return (parts.fragment = parse_pixel(rest)).has_value();
    }
    std::optional<std::uint32_t>* number = word == "object"   ? &parts.object
                                           : word == "vertex" ? &parts.vertex
                                           : word == "line"   ? &parts.line
                                           : word == "point"  ? &parts.point
                                           : word == "piece"  ? &parts.piece
                                                              : nullptr;
    return number != nullptr && (*number = parse_number<std::uint32_t>(rest)).has_value();
}

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::optional<StepId> parse_step_number(std::string_view text) {
    return parse_number<StepId>(text);
}

} // namespace hs::trace
