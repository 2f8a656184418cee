// Grading: an answer against the trace, with the misconception it betrays.
#pragma once

#include "app/lesson/evaluate.hpp"
#include "app/lesson/lesson.hpp"
#include "app/lesson/value.hpp"

#include <string>

namespace hs::lesson {

struct Grade {
    bool right = false;
    std::string message; ///< what to say about a wrong one, plain text with numbers; may be empty
    std::string misconception; ///< name of the known misconception, "" when none is recognised
    PixelSet missing;          ///< pixels questions: asked for, not picked
    PixelSet extra;            ///< picked, not asked for
};

/// The part of a value the question asks for: pixels outside its region do not count.
Value asked_part(const Question& question, Value value);

/// Precondition: the question's expressions were checked (check.hpp) or the result says why not.
Result<Grade> grade(const Question& question, const Value& answer, const Evaluator& evaluate);

} // namespace hs::lesson
