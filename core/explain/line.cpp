#include "core/explain/line.hpp"

#include "core/explain/numbers.hpp"

#include <fmt/format.h>

namespace hs::explain {
namespace {

std::string whole_of(double value) {
    return whole(static_cast<std::int64_t>(value));
}

const char* axis_across(const raster::LineSetup& line) {
    return line.steep ? "x" : "y";
}

Formula bresenham_formula(const raster::LineSetup& line, const raster::LineStep& step) {
    const std::string add = step.moved ? fmt::format("2m − 2n = {}", 2 * (line.rise - line.steps))
                                       : fmt::format("2m = {}", 2 * line.rise);
    return {
        fmt::format("step {} of {}", step.number, line.steps),
        line.minor_step < 0 ? "across if e ≥ 0; then e += 2m, and −2n if it went across"
                            : "across if e > 0; then e += 2m, and −2n if it went across",
        fmt::format(
            "e = {}: {}\ne + ({})",
            whole_of(step.before),
            step.moved ? "across" : "straight on",
            add
        ),
        fmt::format("e = {} for the next pixel", whole_of(step.after))};
}

Formula dda_formula(const raster::LineSetup& line, const raster::LineStep& step) {
    const char* const axis = axis_across(line);
    const float slope = line.steps == 0 ? 0.0F
                                        : static_cast<float>(line.minor_step * line.rise) /
                                              static_cast<float>(line.steps);
    const int rounded = line.steep ? step.pixel.x : step.pixel.y;
    return {
        fmt::format("step {} of {}", step.number, line.steps),
        fmt::format("{} += m/n, then ⌊{} + ½⌋", axis, axis),
        step.number == 0 ? fmt::format("{} = {}", axis, number(static_cast<float>(step.after)))
                         : fmt::format(
                               "{} + {} = {}",
                               number(static_cast<float>(step.before)),
                               number(slope),
                               number(static_cast<float>(step.after))
                           ),
        fmt::format("{} = {}", axis, rounded)};
}

} // namespace

std::vector<Formula>
line_setup_formulas(const raster::LineSetup& line, scene::LineAlgorithm algorithm) {
    const char* const along = line.steep ? "y" : "x";
    Formula formula{
        "the longer extent leads",
        "n = max(|Δx|, |Δy|), m = min(|Δx|, |Δy|) between the end pixels",
        fmt::format(
            "{} → {}\nn = {} along {}, m = {} along {}",
            pixel(line.first),
            pixel(line.last),
            line.steps,
            along,
            line.rise,
            axis_across(line)
        ),
        algorithm == scene::LineAlgorithm::bresenham
            ? fmt::format("e = 2m − n = {}", 2 * line.rise - line.steps)
            : fmt::format("slope {}{}/{}", line.minor_step < 0 ? "−" : "", line.rise, line.steps)};
    return {formula};
}

std::vector<Formula> line_step_formulas(
    const raster::LineSetup& line, const raster::LineStep& step, scene::LineAlgorithm algorithm
) {
    const bool whole_numbers = algorithm == scene::LineAlgorithm::bresenham;
    return {whole_numbers ? bresenham_formula(line, step) : dda_formula(line, step)};
}

std::vector<Formula>
line_fragment_formulas(const trace::FragmentDetail& fragment, const trace::PieceDetail& piece) {
    const auto& v = piece.window;
    const float t = fragment.fragment.barycentric[1];
    const float b = fragment.fragment.barycentric_clip[1];
    return {
        {"place along the line",
         "t = (p − a)·(b − a) / |b − a|², within 0 … 1",
         fmt::format(
             "a = ({}, {})\nb = ({}, {})\np = center of pixel {}",
             number(to_pixels(v[0].fixed.x)),
             number(to_pixels(v[0].fixed.y)),
             number(to_pixels(v[1].fixed.x)),
             number(to_pixels(v[1].fixed.y)),
             pixel(fragment.fragment.pixel)
         ),
         number(t)},
        {"depth, linear in the window",
         "z = z0 + t·(z1 − z0)",
         fmt::format(
             "{} + {}·({} − {})",
             number(v[0].window.depth),
             number(t),
             number(v[1].window.depth),
             number(v[0].window.depth)
         ),
         number(fragment.fragment.depth),
         {"depth"}},
        {"varyings' weight",
         "b = t·(1/w1) / ((1 − t)·(1/w0) + t·(1/w1)), in perspective",
         fmt::format("1/w = {}, {}", number(v[0].inv_w), number(v[1].inv_w)),
         number(b)}};
}

std::string line_setup_sentence(const std::string& who, const raster::LineSetup& line) {
    if (line.steps == 0) {
        return fmt::format("The {} is one pixel, {}.", who, pixel(line.first));
    }
    return fmt::format(
        "The {} goes from pixel {} to {}: {} steps along {}, {} across.",
        who,
        pixel(line.first),
        pixel(line.last),
        line.steps,
        line.steep ? "y" : "x",
        line.rise
    );
}

std::string line_step_sentence(
    const std::string& who,
    const raster::LineSetup& line,
    const raster::LineStep& step,
    scene::LineAlgorithm algorithm
) {
    if (step.number == 0) {
        return fmt::format("The {} begins at pixel {}.", who, pixel(step.pixel));
    }
    const char* const turn = step.moved ? "moves across" : "goes straight on";
    if (algorithm == scene::LineAlgorithm::dda) {
        return fmt::format(
            "The {} {} to pixel {}: {} = {} rounds to {}.",
            who,
            turn,
            pixel(step.pixel),
            axis_across(line),
            number(static_cast<float>(step.after)),
            line.steep ? step.pixel.x : step.pixel.y
        );
    }
    return fmt::format(
        "The {} {} to pixel {}: the error term is {}, and becomes {}.",
        who,
        turn,
        pixel(step.pixel),
        whole_of(step.before),
        whole_of(step.after)
    );
}

} // namespace hs::explain
