#include "app/viewer/lesson_form.hpp"

#include "core/base/check.hpp"

#include <charconv>

namespace hs::viewer {
namespace {

Draft number_draft(const LessonForm& form) {
    double number = 0.0;
    const char* const end = form.number.data() + form.number.size();
    const auto read = std::from_chars(form.number.data(), end, number);
    if (read.ec != std::errc{} || read.ptr != end) {
        return {std::nullopt, "Type a number first, with a point for fractions."};
    }
    return {lesson::Value{number}, ""};
}

} // namespace

Draft draft_of(const lesson::Question& question, const LessonForm& form) {
    switch (question.kind) {
    case lesson::QuestionKind::value: return number_draft(form);
    case lesson::QuestionKind::pixels:
        return {lesson::Value{lesson::make_pixel_set(form.picked)}, ""};
    case lesson::QuestionKind::choice:
    case lesson::QuestionKind::pass_fail:
        if (form.choice < 0) {
            return {std::nullopt, "Choose an answer first."};
        }
        return {lesson::Value{question.choices[static_cast<std::size_t>(form.choice)].value}, ""};
    }
    HS_CHECK(false, "every kind of question is handled");
    return {};
}

} // namespace hs::viewer
