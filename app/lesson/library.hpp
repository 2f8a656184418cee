// Where the lessons are.
#pragma once

#include <filesystem>
#include <vector>

namespace hs::lesson {

/// The lessons that come with the program: beside it once installed, else in the source tree.
std::filesystem::path lessons_folder();

/// Folders below `folder` that hold a lesson.md, sorted by name.
std::vector<std::filesystem::path> find_lessons(const std::filesystem::path& folder);

/// Whether a path given by a user is a lesson: such a folder, or a lesson.md itself.
bool is_lesson(const std::filesystem::path& path);

} // namespace hs::lesson
