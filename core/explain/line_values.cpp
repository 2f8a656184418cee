// The values of lines: the end pixels, and the decision at every pixel between them.
#include "core/explain/value_list.hpp"
#include "core/raster/line_bresenham.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace hs::explain {
namespace {

using trace::StepKind;

const Operation pixel_holding{
    "pixel", 0, UnitRule::none, [](std::span<const Number> n) -> Number {
        const auto fixed = static_cast<std::int32_t>(std::get<std::int64_t>(n[0]));
        return std::int64_t{raster::pixel_of({fixed, 0}).x};
    }};
const Operation absolute{"abs", 0, UnitRule::first, [](std::span<const Number> n) -> Number {
                             return std::abs(std::get<std::int64_t>(n[0]));
                         }};

Whole setup_number(const StepContext& context, const char* name, int value) {
    return context.value(StepKind::setup, name, std::int64_t{value});
}

Whole whole(std::int64_t value) {
    return Whole{value};
}

/// The error term the decision was made by, before it; n and m as setup found them.
void add_bresenham(ValueList& list, const StepContext& context, const raster::LineStep& step) {
    const raster::LineSetup& line = *context.piece().line;
    const Whole n = setup_number(context, "n", line.steps);
    const Whole m = setup_number(context, "m", line.rise);
    const std::int64_t across = raster::steps_across(line, step.number - 1);
    const Whole k = operand("k", std::int64_t{step.number}, {{}, {}, "steps along the line so far"});
    const Whole j = operand("j", across, {{}, {}, "steps across it so far"});
    const Whole error = list.add("e", (whole(2) * m * k - whole(2) * n * j) - n);
    const Truth moves = call<bool>(
        line.minor_step < 0 ? operations::greater_or_equal : operations::greater, error, whole(0)
    );
    if (step.number > 0) {
        list.add("moves across", moves);
    }
    list.add("next e", step.moved ? error + (whole(2) * m - whole(2) * n) : error + whole(2) * m);
}

const Operation rounded{"floor", 0, UnitRule::none, [](std::span<const Number> n) -> Number {
                            return static_cast<std::int64_t>(std::floor(std::get<float>(n[0])));
                        }};

/// The coordinate across the line: the sum so far plus the slope.
void add_dda(ValueList& list, const StepContext& context, const raster::LineStep& step) {
    const raster::LineSetup& line = *context.piece().line;
    const char* const axis = line.steep ? "x" : "y";
    Real sum = operand(
        fmt::format("{} before", axis),
        static_cast<float>(step.before),
        {{}, {}, "the sum of all steps before"}
    );
    if (step.number > 0) {
        const Real rise = to_float(whole(line.minor_step) * setup_number(context, "m", line.rise));
        sum = sum + rise / to_float(setup_number(context, "n", line.steps));
    }
    const Real after = list.add(axis, sum);
    list.add("across", call<std::int64_t>(rounded, after + Real{0.5F}));
}

} // namespace

void add_line_setup_values(ValueList& list, const StepContext& context) {
    const trace::PieceDetail& piece = context.piece();
    const auto end_pixel = [&](unsigned corner, unsigned axis) {
        const FixedPosition& fixed = piece.window[corner].fixed;
        const Whole place = context.value(
            StepKind::viewport,
            fmt::format("v{}.fixed.{}", corner, axis_names[axis]),
            std::int64_t{axis == 0 ? fixed.x : fixed.y},
            1
        );
        return list.add(
            fmt::format("{} {}", corner == 0 ? "first" : "last", axis_names[axis]),
            call<std::int64_t>(pixel_holding, place)
        );
    };
    if (context.step.primitive == scene::PrimitiveKind::point) {
        end_pixel(0, 0);
        end_pixel(0, 1);
        return;
    }
    const Whole first_x = end_pixel(0, 0);
    const Whole first_y = end_pixel(0, 1);
    const Whole dx = list.add("Δx", end_pixel(1, 0) - first_x);
    const Whole dy = list.add("Δy", end_pixel(1, 1) - first_y);
    list.add("n", call<std::int64_t>(absolute, piece.line->steep ? dy : dx));
    list.add("m", call<std::int64_t>(absolute, piece.line->steep ? dx : dy));
}

void add_line_step_values(ValueList& list, const StepContext& context) {
    const raster::LineStep& step = *context.detail.traversal->line;
    if (context.step.primitive == scene::PrimitiveKind::point) {
        list.add("x", setup_number(context, "first x", step.pixel.x));
        list.add("y", setup_number(context, "first y", step.pixel.y));
    } else if (context.call().settings.line_algorithm == scene::LineAlgorithm::dda) {
        add_dda(list, context, step);
    } else {
        add_bresenham(list, context, step);
    }
}

} // namespace hs::explain
