// Any text as a lesson: refused with located reasons, or read.
#include "app/lesson/lesson.hpp"

#include "tests/fuzz/claims.hpp"
#include "tests/fuzz/target.hpp"

#include <cstdint>
#include <string_view>

using namespace hs;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text{reinterpret_cast<const char*>(data), size};
    const auto lesson = lesson::parse_lesson(text, "lesson.md");
    if (!lesson) {
        fuzz::check_diagnostics(lesson.diagnostics(), text);
        return 0;
    }
    HS_CHECK(!lesson->steps.empty(), "a lesson has steps");
    for (std::size_t i = 0; i < lesson->steps.size(); ++i) {
        lesson::scene_of_step(*lesson, i);
    }
    return 0;
}
