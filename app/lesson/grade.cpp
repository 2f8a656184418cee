#include "app/lesson/grade.hpp"

#include "app/lesson/explain_pixels.hpp"
#include "app/lesson/placeholder.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace hs::lesson {

namespace {

constexpr int never_wrap = 1 << 20;

PixelSet inside(const PixelSet& pixels, const std::optional<PixelRect>& region) {
    PixelSet result;
    std::ranges::copy_if(pixels, std::back_inserter(result), [&](const PixelPos& pixel) {
        return !region || region->contains(pixel);
    });
    return result;
}

PixelSet without(const PixelSet& pixels, const PixelSet& others) {
    PixelSet result;
    std::ranges::copy_if(pixels, std::back_inserter(result), [&](const PixelPos& pixel) {
        return std::ranges::find(others, pixel) == others.end();
    });
    return result;
}

/// Whether two answers to a question are the same.
bool agree(const Question& question, const Value& a, const Value& b) {
    const auto* const number_a = std::get_if<double>(&a);
    const auto* const number_b = std::get_if<double>(&b);
    if (number_a != nullptr && number_b != nullptr) {
        // What a keyboard can express is not always a float's exact value
        const double slack = 1e-6 * (1.0 + std::abs(*number_b));
        return std::abs(*number_a - *number_b) <= question.tolerance + slack;
    }
    const auto* const pixels_a = std::get_if<PixelSet>(&a);
    const auto* const pixels_b = std::get_if<PixelSet>(&b);
    if (pixels_a != nullptr && pixels_b != nullptr) {
        return inside(*pixels_a, question.region) == inside(*pixels_b, question.region);
    }
    return print_value(a) == print_value(b);
}

/// The value of a wrong answer: read from the trace, or one of the choices.
Result<Value> value_of(const WrongAnswer& wrong, const Evaluator& evaluate) {
    return wrong.answer ? evaluate(*wrong.answer) : Result<Value>{Value{wrong.choice}};
}

/// Names the misconception whose answer this is, if it is a known one.
Result<Done> recognize(
    const Question& question,
    const Value& answer,
    const Value& right,
    const Evaluator& evaluate,
    Grade& grade
) {
    for (const WrongAnswer& wrong : question.wrong) {
        const Result<Value> value = value_of(wrong, evaluate);
        if (!value) {
            return value.diagnostics();
        }
        if (!agree(question, answer, *value)) {
            continue;
        }
        Diagnostics problems;
        const Filling filling{
            .evaluate = &evaluate,
            .is_hidden = {},
            .named_values =
                {
                    {"right", asked_part(question, right)},
                    {"wrong", asked_part(question, *value)},
                },
        };
        const Document said = fill_in_text(wrong.message, wrong.place, filling, problems);
        if (!problems.empty()) {
            return problems;
        }
        grade.misconception = wrong.misconception;
        grade.message = to_plain_text(said, never_wrap);
        return done;
    }
    return done;
}

} // namespace

Value asked_part(const Question& question, Value value) {
    if (const auto* const pixels = std::get_if<PixelSet>(&value)) {
        return inside(*pixels, question.region);
    }
    return value;
}

Result<Grade> grade(const Question& question, const Value& answer, const Evaluator& evaluate) {
    const Result<Value> right = evaluate(question.answer);
    if (!right) {
        return right.diagnostics();
    }
    Grade grade;
    grade.right = agree(question, answer, *right);
    const auto* const picked = std::get_if<PixelSet>(&answer);
    const auto* const wanted = std::get_if<PixelSet>(&*right);
    if (picked != nullptr && wanted != nullptr) {
        grade.missing = without(inside(*wanted, question.region), *picked);
        grade.extra = without(inside(*picked, question.region), *wanted);
    }
    if (!grade.right) {
        const Result<Done> recognized = recognize(question, answer, *right, evaluate, grade);
        if (!recognized) {
            return recognized.diagnostics();
        }
        const std::string edges = explain_pixels(question.answer, grade, evaluate);
        grade.message += (grade.message.empty() || edges.empty() ? "" : "\n") + edges;
    }
    while (grade.message.ends_with('\n')) {
        grade.message.pop_back();
    }
    return grade;
}

} // namespace hs::lesson
