// An answer while it is being written, before it is handed to the lesson's session.
#pragma once

#include "core/base/pixel.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace hs::viewer {

class LessonForm {
public:
    std::string number;
    int choice = -1;
    std::vector<PixelPos> picked;

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

} // namespace hs::viewer
