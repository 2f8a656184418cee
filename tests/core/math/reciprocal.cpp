#include "core/math/reciprocal.hpp"

#include "tests/support/catch.hpp"

#include <limits>

using namespace hs;

TEST_CASE("the reciprocal of zero is an infinity, under sanitizers too", "[math]") {
    const float infinity = std::numeric_limits<float>::infinity();
    CHECK(math::reciprocal(4.0F) == 0.25F);
    CHECK(math::reciprocal(0.0F) == infinity);
    CHECK(math::reciprocal(-0.0F) == -infinity);
    CHECK(math::reciprocal(infinity) == 0.0F);
}
