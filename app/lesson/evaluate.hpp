// Expressions over the trace, and the values they have.
#pragma once

#include "app/lesson/lesson.hpp"
#include "app/lesson/recordings.hpp"
#include "app/lesson/value.hpp"
#include "core/trace/step.hpp"

#include <memory>

namespace hs::lesson {

/// Reads expressions in the frame of one lesson step.
class Evaluator {
public:
    /// `stand` completes subjects: standing on a vertex, "ndc.x" alone is that vertex's.
    Evaluator(
        std::shared_ptr<RecordingCache> recordings,
        SceneChoice choice,
        std::shared_ptr<const trace::Recording> recording,
        const trace::Step& stand
    );

    /// Errors are sentences without a file, placed where the expression stands.
    [[nodiscard]] Result<Value> operator()(const Expression& expression) const;

    [[nodiscard]] const trace::Recording& recording() const { return *recording_; }
    [[nodiscard]] const trace::Step& stand() const { return stand_; }

private:
    std::shared_ptr<RecordingCache> recordings_;
    SceneChoice choice_;
    std::shared_ptr<const trace::Recording> recording_;
    trace::Step stand_;
};

} // namespace hs::lesson
