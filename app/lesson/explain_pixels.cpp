#include "app/lesson/explain_pixels.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

namespace hs::lesson {

namespace {

constexpr std::size_t most_lines = 3;
constexpr std::array<const char*, 3> edge_names{"E01", "E12", "E20"};

/// The three edge values as a sentence with its conclusion.
std::optional<std::string>
explain_pixel(const Expression& asked, PixelPos pixel, const Evaluator& evaluate) {
    const std::string at = fmt::format("{} / pixel {},{}", asked.of, pixel.x, pixel.y);
    std::string numbers;
    std::string reason = "all three are positive: covered";
    for (const char* const edge : edge_names) {
        const Result<Value> value =
            evaluate({.quantity = edge, .of = at, .settings = {}, .place = {}});
        const Result<Value> owns = evaluate(
            {.quantity = std::string{edge} + ".owns ties",
             .of = asked.of,
             .settings = {},
             .place = {}}
        );
        if (!value || !owns) {
            return std::nullopt;
        }
        const double e = std::get<double>(*value);
        numbers += fmt::format("{}{} = {}", numbers.empty() ? "" : ", ", edge, print_value(*value));
        if (e < 0.0) {
            reason = fmt::format("{} is negative: outside that edge", edge);
            break;
        }
        if (e == 0.0 && !std::get<bool>(*owns)) {
            reason = fmt::format("{} is 0 and that edge does not own its ties: not covered", edge);
        } else if (e == 0.0 && reason.ends_with(": covered")) {
            reason = fmt::format("{} is 0 and that edge owns its ties: covered", edge);
        }
    }
    return fmt::format("Pixel ({}, {}): {}; {}.", pixel.x, pixel.y, numbers, reason);
}

} // namespace

std::string explain_pixels(const Expression& asked, const Grade& grade, const Evaluator& evaluate) {
    std::string text;
    std::size_t lines = 0;
    for (const PixelSet* const pixels : {&grade.extra, &grade.missing}) {
        for (const PixelPos& pixel : *pixels) {
            if (lines == most_lines) {
                return text;
            }
            const std::optional<std::string> line = explain_pixel(asked, pixel, evaluate);
            if (!line) {
                return {};
            }
            text += (lines == 0 ? "" : "\n") + *line;
            ++lines;
        }
    }
    return text;
}

} // namespace hs::lesson
