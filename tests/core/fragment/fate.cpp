#include "core/fragment/fate.hpp"

#include "tests/support/catch.hpp"

using namespace hs;

TEST_CASE("the number of fates is the number of their names", "[fragment]") {
    CHECK(names<fragment::FragmentFate>().size() == fragment::fate_count);
}
