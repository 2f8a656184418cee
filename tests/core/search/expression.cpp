#include "core/search/expression.hpp"

#include "tests/support/catch.hpp"

#include <string>

using namespace hs;
using search::Expression;
using search::Name;
using search::Value;

namespace {

/// A row with one name of every kind.
struct Row {
    double depth = 0.25;
    std::int64_t x = 31;
    std::string_view fate = "written";
    int reads = 0;
};

std::vector<Name> names_of(Row& row) {
    return {
        {"fragment.depth", [&row]() -> Value { return row.depth; }},
        {"fragment.pixel.x",
         [&row]() -> Value {
             ++row.reads;
             return row.x;
         }},
        {"fragment.fate", [&row]() -> Value { return row.fate; }, {"written", "depth failed"}},
        {"triangle.vertices.0", [&row]() -> Value { return row.x * 2; }}};
}

bool is_true(const std::string& text, Row row = {}) {
    Result<Expression> expression = Expression::compile(text, names_of(row));
    INFO(text);
    REQUIRE(expression);
    const Result<bool> answer = (*expression)();
    if (!answer) {
        FAIL(answer.diagnostics().front().to_string());
    }
    return *answer;
}

/// What is said about a text, when it is loaded or when it is asked.
std::string complaint(const std::string& text) {
    Row row;
    Result<Expression> expression = Expression::compile(text, names_of(row));
    if (!expression) {
        return expression.diagnostics().front().to_string();
    }
    const Result<bool> answer = (*expression)();
    return answer ? "no complaint" : answer.diagnostics().front().to_string();
}

} // namespace

TEST_CASE("names read the row as it is when asked", "[unit][search]") {
    Row row;
    Result<Expression> expression =
        Expression::compile("fragment.depth < 0.5 and fragment.pixel.x >= 31", names_of(row));
    REQUIRE(expression);
    CHECK(*(*expression)());
    row.x = 30;
    CHECK_FALSE(*(*expression)());
    row.x = 40;
    row.depth = 0.75;
    const int before = row.reads;
    CHECK_FALSE(*(*expression)());
    CHECK(row.reads == before); // a false left side leaves the right one unread
}

TEST_CASE("enumerators are compared by name, indices stand in brackets", "[unit][search]") {
    CHECK(is_true("fragment.fate == 'written'"));
    CHECK_FALSE(is_true("fragment.fate == \"depth failed\""));
    CHECK(is_true("triangle.vertices[0] == 62"));
    CHECK(is_true("math.abs(fragment.depth - 0.25) < 1e-9 and not (fragment.pixel.x == 3)"));
    CHECK(is_true("(function(d) return d * d == 0.0625 end)(fragment.depth)"));
}

TEST_CASE("an expression knows what it mentions", "[unit][search]") {
    Row row;
    const Result<Expression> expression = Expression::compile(
        "fragment.fate == 'written' or fragment.depth < 1 or fragment.fate ~= 'depth failed'",
        names_of(row)
    );
    REQUIRE(expression);
    CHECK(expression->mentioned() == std::vector<std::size_t>{2, 0});
}

TEST_CASE("a mistake is one located sentence that says what to write", "[unit][search]") {
    CHECK(complaint("") == "expression: is empty; write a comparison such as fragment.depth < 0.5");
    CHECK(
        complaint("fragment.dept < 1") ==
        "expression: there is no fragment.dept; did you mean \"fragment.depth\"?"
    );
    CHECK(
        complaint("true or fragment.pixel.z == 1") ==
        "expression: there is no fragment.pixel.z; did you mean \"fragment.pixel.x\"?"
    );
    CHECK(
        complaint("fragment.fate == 'writen'") ==
        "expression: nothing named here is ever \"writen\"; there are \"written\" or \"depth "
        "failed\""
    );
    CHECK(complaint("fragmnt.depth < 1") == "expression:1: there is no 'fragmnt'");
    CHECK(
        complaint("fragment.depth") ==
        "expression: the answer is a number, not true or false; compare it with something"
    );
    CHECK(complaint("fragment.depth = 1").find("; 'equal' is written ==") != std::string::npos);
    CHECK(
        complaint("fragment.depth != 1").find("; 'not equal' is written ~=") != std::string::npos
    );
    CHECK(complaint("fragment.depth < 1 and\n (").starts_with("expression:2: "));
    CHECK(complaint("fragment.fate < 1").find("attempt to compare") != std::string::npos);
    CHECK(complaint(std::string(5000, ' ')).find("at most 4096") != std::string::npos);
}

TEST_CASE("an expression can neither run on, nor fill memory, nor reach out", "[unit][search]") {
    CHECK(
        complaint("(function() while true do end end)()")
            .find("stopped after 100000 operations; an expression is one comparison, not a loop") !=
        std::string::npos
    );
    CHECK(
        complaint("(function() local s = 'a' for i = 1, 60 do s = s .. s end return s end)()")
            .find("text \"a\"") != std::string::npos
    );
    CHECK(
        complaint("(function() local s = [[a]] for i = 1, 60 do s = s .. s end return true end)()")
            .find("not enough memory") != std::string::npos
    );
    CHECK(
        complaint("(function() local function f() return f() + 1 end return f() end)() == 1")
            .find("stopped after") != std::string::npos
    );
    for (const char* outside :
         {"os", "io", "require", "load", "print", "pcall", "string", "debug"}) {
        CHECK(
            complaint(std::string{outside} + ".x == 1") ==
            "expression:1: there is no '" + std::string{outside} + "'"
        );
    }
    CHECK(complaint("math.random() < 2").find("nil value") != std::string::npos);
    CHECK(complaint("([[a]]):rep(9) == [[a]]").find("attempt to index") != std::string::npos);
    CHECK(complaint("\x1bLua").find("unexpected symbol") != std::string::npos);
    CHECK(complaint(std::string(3000, '(') + "1").find("C stack overflow") != std::string::npos);
}

TEST_CASE("an error leaves the expression able to answer the next row", "[unit][search]") {
    Row row;
    Result<Expression> expression = Expression::compile(
        "(function() if fragment.pixel.x == 1 then return nil + 1 end return true end)()",
        names_of(row)
    );
    REQUIRE(expression);
    for (int i = 0; i < 3; ++i) {
        row.x = 1;
        CHECK_FALSE((*expression)());
        row.x = 2;
        CHECK(*(*expression)());
    }
}
