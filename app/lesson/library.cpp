#include "app/lesson/library.hpp"

#include <algorithm>
#include <system_error>

namespace hs::lesson {

namespace {

namespace fs = std::filesystem;

constexpr const char* lesson_name = "lesson.md";

} // namespace

fs::path lessons_folder() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path installed =
        (program.parent_path() / HALFSPACE_LESSONS_FROM_PROGRAM).lexically_normal();
    return !error && fs::is_directory(installed, error) ? installed
                                                        : fs::path{HALFSPACE_LESSONS_IN_SOURCE};
}

std::vector<fs::path> find_lessons(const fs::path& folder) {
    std::vector<fs::path> lessons;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        if (fs::exists(entry.path() / lesson_name, error)) {
            lessons.push_back(entry.path());
        }
    }
    std::ranges::sort(lessons);
    return lessons;
}

bool is_lesson(const fs::path& path) {
    std::error_code error;
    return fs::exists(path / lesson_name, error) ||
           (path.filename() == lesson_name && fs::exists(path, error));
}

} // namespace hs::lesson
