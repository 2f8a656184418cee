// An answer while it is being written, before it is handed to the lesson's session.
#pragma once

#include "app/lesson/lesson.hpp"
#include "app/lesson/value.hpp"
#include "core/base/pixel.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace hs::viewer {

class LessonForm {
public:
    std::string number;
    int choice = -1;
    std::vector<PixelPos> picked;
    bool wants_keyboard = false; ///< the field takes it in the next frame

    /// Forgets what was written when the lesson has moved on.
    void follow(std::size_t step) {
        if (step != step_) {
            *this = LessonForm{};
            step_ = step;
        }
    }
    void toggle(PixelPos pixel) {
        const auto found = std::ranges::find(picked, pixel);
        if (found == picked.end()) {
            picked.push_back(pixel);
        } else {
            picked.erase(found);
        }
    }

private:
    std::size_t step_ = 0;
};

/// The answer as written so far, or why it cannot be handed in.
struct Draft {
    std::optional<lesson::Value> value;
    std::string why;
};
Draft draft_of(const lesson::Question& question, const LessonForm& form);

} // namespace hs::viewer
