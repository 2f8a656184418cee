// Every lesson of tests/must_fail/lessons is refused with exactly the sentences at its end:
// `<!-- expect: line:column: sentence -->`, one for each error, in order.
#include "app/lesson/check.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Sentences = std::vector<std::string>;

Sentences read_expected(const fs::path& path) {
    const std::string begin = "<!-- expect: ";
    const std::string end = " -->";
    Sentences expected;
    std::ifstream stream{path};
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with(begin) && line.ends_with(end)) {
            expected.push_back(line.substr(begin.size(), line.size() - begin.size() - end.size()));
        }
    }
    return expected;
}

/// What loading and checking complain about; the lesson's own name is left out, other files keep
/// theirs without the folder.
Sentences complaints_of(const fs::path& path) {
    const hs::Result<hs::lesson::Lesson> lesson = hs::lesson::load_lesson(path);
    const hs::Diagnostics problems =
        lesson ? hs::lesson::check_lesson(*lesson) : lesson.diagnostics();
    Sentences sentences;
    for (hs::Diagnostic problem : problems) {
        const bool own = problem.file == path.string();
        problem.file = own ? "" : fs::path{problem.file}.filename().string();
        const std::string text = problem.to_string();
        sentences.push_back(text.starts_with(':') ? text.substr(1) : text);
    }
    return sentences;
}

} // namespace

TEST_CASE("every bad lesson is refused with its located sentences", "[lesson][must_fail]") {
    std::size_t count = 0;
    for (const auto& entry :
         fs::directory_iterator{hs::test::source_dir() / "tests/must_fail/lessons"}) {
        INFO(entry.path());
        const Sentences expected = read_expected(entry.path());
        CHECK_FALSE(expected.empty());
        CHECK(complaints_of(entry.path()) == expected);
        ++count;
    }
    CHECK(count >= 50);
}

TEST_CASE("a lesson that is not there is refused by name", "[lesson][must_fail]") {
    const auto lesson = hs::lesson::load_lesson("no/such/lesson");

    REQUIRE_FALSE(lesson);
    CHECK(lesson.diagnostics().front().to_string().starts_with("no/such/lesson: cannot be read"));
}
