#include "app/lesson/evaluate.hpp"

#include "app/lesson/quantity.hpp"

#include <utility>

namespace hs::lesson {

namespace {

Diagnostics placed(Diagnostics problems, Place place) {
    for (Diagnostic& problem : problems) {
        // Errors of a scene know where they are; those of an expression stand where it stands
        if (problem.file.empty()) {
            problem.line = place.line;
            problem.column = place.column;
        }
    }
    return problems;
}

} // namespace

Evaluator::Evaluator(
    std::shared_ptr<RecordingCache> recordings,
    SceneChoice choice,
    std::shared_ptr<const trace::Recording> recording,
    const trace::Step& stand
)
    : recordings_(std::move(recordings)),
      choice_(std::move(choice)),
      recording_(std::move(recording)),
      stand_(stand) {
    HS_CHECK(recording_ != nullptr, "expressions are read from a recording");
}

Result<Value> Evaluator::operator()(const Expression& expression) const {
    std::shared_ptr<const trace::Recording> frame = recording_;
    if (!expression.settings.empty()) {
        SceneChoice changed = choice_;
        changed.assignments.insert(
            changed.assignments.end(), expression.settings.begin(), expression.settings.end()
        );
        const RecordingCache::Entry& entry = recordings_->get(changed);
        if (!entry) {
            return placed(entry.diagnostics(), expression.place);
        }
        frame = *entry;
    }
    Result<Value> value = read_quantity(expression.quantity, expression.of, *frame, stand_);
    if (!value) {
        return placed(value.diagnostics(), expression.place);
    }
    if (expression.times == 1.0 && expression.plus == 0.0) {
        return value;
    }
    const auto* const number = std::get_if<double>(&*value);
    if (number == nullptr) {
        return placed(
            {{"", 0, 0, "\"" + expression.quantity + "\" is no number to multiply or add to"}},
            expression.place
        );
    }
    return Value{expression.times * *number + expression.plus};
}

} // namespace hs::lesson
