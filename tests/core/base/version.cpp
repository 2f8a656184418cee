#include "core/base/version.hpp"

#include "tests/support/catch.hpp"

#include <algorithm>

TEST_CASE("the program's version is three numbers with dots between", "[base]") {
    const std::string_view version = hs::program_version();

    CHECK(std::ranges::count(version, '.') == 2);
    CHECK(version.find_first_not_of("0123456789.") == std::string_view::npos);
}
