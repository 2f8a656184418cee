// A lesson verified without a display, so that the course cannot rot.
#pragma once

#include "app/lesson/lesson.hpp"

namespace hs::lesson {

/// Empty when all is well: every scene loads, every step path exists, every placeholder has a
/// value, every right answer is graded right and every wrong one wrong by its name, every check
/// holds, every change changes something, and the lesson asks at least one question and lets
/// change at least one thing.
Diagnostics check_lesson(const Lesson& lesson);

} // namespace hs::lesson
