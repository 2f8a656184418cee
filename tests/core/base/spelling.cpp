#include "core/base/spelling.hpp"

#include "tests/support/catch.hpp"

#include <array>

using namespace hs;

namespace {

constexpr std::array<std::string_view, 4> keys{"depth.test", "depth.write", "cull", "size"};

} // namespace

TEST_CASE("a slip of the fingers finds the name that was meant", "[unit][base]") {
    CHECK(nearest_name("depth.tset", keys) == "depth.test");
    CHECK(nearest_name("dept.write", keys) == "depth.write");
    CHECK(nearest_name("cul", keys) == "cull");
    CHECK(nearest_name("szie", keys) == "size");
    CHECK(did_you_mean("cul", keys) == "; did you mean \"cull\"?");
}

TEST_CASE("a name far from all others finds none", "[unit][base]") {
    CHECK(nearest_name("blending", keys).empty());
    CHECK(nearest_name("", keys).empty());
    CHECK(nearest_name(std::string(100'000, 'x'), keys).empty());
    CHECK(did_you_mean("blending", keys).empty());
}

TEST_CASE("choices read as a sentence lists them", "[unit][base]") {
    CHECK(list_of_choices(keys) == "\"depth.test\", \"depth.write\", \"cull\" or \"size\"");
    CHECK(list_of_choices(std::span{keys}.first(1)) == "\"depth.test\"");
}
