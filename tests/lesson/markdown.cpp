#include "app/lesson/markdown.hpp"

#include "tests/support/catch.hpp"

namespace hs::lesson {

namespace {

Document read(std::string_view text) {
    Diagnostics problems;
    Document document;
    for (MarkdownPart& part : parse_markdown(text).parts) {
        if (auto* const block = std::get_if<Block>(&part)) {
            document.push_back(std::move(*block));
        }
    }
    return document;
}

} // namespace

TEST_CASE("styles of Markdown become styled spans", "[lesson]") {
    const Document document = read("plain *soft* **loud** `code` [link](there)\n");

    REQUIRE(document.size() == 1);
    const Spans& spans = document[0].spans;
    REQUIRE(spans.size() == 8);
    CHECK(spans[1].emphasis);
    CHECK(spans[3].strong);
    CHECK(spans[5].code);
    CHECK(spans[7].link == "there");
    CHECK(to_plain_text(spans) == "plain soft loud code link");
}

TEST_CASE("lists come flat, with depth and marker", "[lesson]") {
    const Document document = read("1. one\n2. two\n   - deep\n\n   - deeper\n3. three\n");

    REQUIRE(document.size() == 5);
    CHECK(document[1].marker == "2.");
    CHECK(document[2].level == 2);
    CHECK(document[2].marker == "•");
    CHECK(document[4].marker == "3.");
    CHECK(document[4].level == 1);
}

TEST_CASE("tables keep rows, cells and alignment", "[lesson]") {
    const Document document = read("| a | b |\n|:--|--:|\n| 1 | 22 |\n| 333 | 4 |\n");

    REQUIRE(document.size() == 1);
    CHECK(document[0].columns == std::vector<Align>{Align::left, Align::right});
    CHECK(to_plain_text(document) == "  a     b\n  1    22\n  333   4\n");
}

TEST_CASE("a code block keeps its lines", "[lesson]") {
    const Document document = read("```\nfor y\n  for x\n```\n");

    REQUIRE(document.size() == 1);
    CHECK(document[0].kind == BlockKind::code);
    CHECK(to_plain_text(document[0].spans) == "for y\n  for x");
}

TEST_CASE("a placeholder is a span of its own, in text, tables and code", "[lesson]") {
    const Document document = read("x is {{ndc.x of vertex 1}}.\n\n"
                                   "```\ny = {{ ndc.y }}\n```\n\n"
                                   "| a |\n|---|\n| {{visits}} |\n");

    REQUIRE(document.size() == 3);
    CHECK(document[0].spans[1].placeholder == "ndc.x of vertex 1");
    CHECK(document[0].spans[2].text == ".");
    CHECK(document[1].spans[1].placeholder == "ndc.y");
    CHECK(document[1].spans[1].code);
    CHECK(document[2].cells[1][0][0].placeholder == "visits");
}

TEST_CASE("a placeholder may be broken over two lines", "[lesson]") {
    const Document document = read("the number {{ndc.x of\nvertex 1}} here\n");

    REQUIRE(document[0].spans.size() == 3);
    CHECK(document[0].spans[1].placeholder == "ndc.x of vertex 1");
}

TEST_CASE("places are lines and columns of the file", "[lesson]") {
    const Document document = read("# Title\n\nFirst.\n\nSecond line\nholds *a* {{visits}}.\n");

    REQUIRE(document.size() == 3);
    CHECK(document[0].place == Place{1, 3});
    CHECK(document[2].place == Place{5, 1});
    CHECK(document[2].spans[3].place == Place{6, 11});
}

TEST_CASE("a block fenced with the word halfspace is kept apart, with its line", "[lesson]") {
    const std::string_view text =
        "Text.\n\n```halfspace\n\na = 1\n  b = 2\n```\n\n```toml\nc = 3\n```\n";
    const Markdown markdown = parse_markdown(text);

    REQUIRE(markdown.parts.size() == 3);
    const auto& fence = std::get<FencedBlock>(markdown.parts[1]);
    CHECK(fence.text == "\na = 1\n  b = 2\n");
    CHECK(fence.first_line == 4);
    CHECK(std::get<Block>(markdown.parts[2]).kind == BlockKind::code);
}

TEST_CASE("plain text is wrapped between words and indented under its bullet", "[lesson]") {
    const Document document = read("- one two three four five six seven\n");

    CHECK(to_plain_text(document, 20) == "  • one two three\n    four five six\n    seven\n");
}

TEST_CASE("line ends of another system change nothing", "[lesson]") {
    const Markdown markdown = parse_markdown("A\r\nB\r\n\r\n```halfspace\r\na = 1\r\n```\r\n");

    REQUIRE(markdown.problems.empty());
    REQUIRE(markdown.parts.size() == 2);
    CHECK(to_plain_text(std::get<Block>(markdown.parts[0]).spans) == "A B");
    CHECK(std::get<FencedBlock>(markdown.parts[1]).text == "a = 1\n");
}

TEST_CASE("comments are left out, other HTML is refused", "[lesson]") {
    CHECK(to_plain_text(read("<!-- {{unfinished -->\n\nText<!-- aside -->.\n")) == "Text.\n");

    const Markdown markdown = parse_markdown("Text.\n\nA <b>bold</b> word.\n");
    REQUIRE(markdown.problems.size() == 2);
    CHECK(markdown.problems[0].line == 3);
    CHECK(markdown.problems[0].column == 3);
    CHECK(markdown.problems[0].message == "HTML is not shown: write Markdown");
}

} // namespace hs::lesson
