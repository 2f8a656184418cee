#include "core/base/diagnostic.hpp"

#include "tests/support/catch.hpp"

using namespace hs;

TEST_CASE("a diagnostic says file, line, column and message, as far as known", "[base]") {
    CHECK(Diagnostic{"a.obj", 12, 3, "what"}.to_string() == "a.obj:12:3: what");
    CHECK(Diagnostic{"a.obj", 12, 0, "what"}.to_string() == "a.obj:12: what");
    CHECK(Diagnostic{"a.obj", 0, 0, "what"}.to_string() == "a.obj: what");
    CHECK(Diagnostic{"", 0, 0, "what"}.to_string() == "what");
}

TEST_CASE("a result holds a value or the reasons why there is none", "[base]") {
    const Result<int> good = 7;
    REQUIRE(good);
    CHECK(*good == 7);

    const Result<int> bad = Diagnostic{"f", 1, 2, "no"};
    REQUIRE_FALSE(bad);
    REQUIRE(bad.diagnostics().size() == 1);
    CHECK(bad.diagnostics().front().message == "no");
}
