// docs/lessons.md: its example is a lesson that holds, and its table is complete.
#include "app/lesson/check.hpp"
#include "app/lesson/markdown.hpp"
#include "app/lesson/quantity.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

namespace hs::lesson {

namespace {

std::string read_page() {
    std::ifstream file(test::source_dir() / "docs/lessons.md");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

/// The first code block of the page.
std::string find_example(const std::string& page) {
    for (const MarkdownPart& part : parse_markdown(page).parts) {
        const auto* const block = std::get_if<Block>(&part);
        if (block != nullptr && block->kind == BlockKind::code) {
            return to_plain_text(block->spans);
        }
    }
    return {};
}

} // namespace

TEST_CASE("the example of the recipe is a lesson that holds", "[lesson]") {
    const auto file = test::source_dir() / "lessons/01-one-triangle/lesson.md";

    const Lesson lesson = parse_lesson(find_example(read_page()), file).value();

    std::string problems;
    for (const Diagnostic& problem : check_lesson(lesson)) {
        problems += problem.to_string() + '\n';
    }
    CHECK(problems.empty());
}

TEST_CASE("the recipe lists every quantity with its explanation", "[lesson]") {
    const std::string page = read_page();
    for (const Quantity& quantity : quantities()) {
        INFO(quantity.name);
        CHECK(page.find(fmt::format("| `{}` |", quantity.name)) != std::string::npos);
        CHECK(page.find(fmt::format("| {} |\n", quantity.explanation)) != std::string::npos);
    }
}

TEST_CASE("the recipe lists every view, panel and kind of question", "[lesson]") {
    const std::string page = read_page();
    const auto check_names = [&](const auto& rows) {
        for (const auto& row : rows) {
            INFO(row.name);
            CHECK(
                (row.name == "unchanged" ||
                 page.find(fmt::format("`{}`", row.name)) != std::string::npos)
            );
        }
    };
    check_names(names<View>());
    check_names(names<Panel>());
    check_names(names<QuestionKind>());
}

} // namespace hs::lesson
