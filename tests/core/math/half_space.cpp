#include "core/math/half_space.hpp"

#include "tests/support/catch.hpp"

#include <limits>

using namespace hs;

TEST_CASE("the signed distance is the dot product with the plane", "[math]") {
    const math::HalfSpace h{1.0F, -2.0F, 3.0F, 4.0F};
    CHECK(math::signed_distance(h, {5.0F, 6.0F, 7.0F, 8.0F}) == 5.0F - 12.0F + 21.0F + 32.0F);
}

TEST_CASE("points on the plane are inside, and not a number is not", "[math]") {
    CHECK(math::inside(0.0F));
    CHECK(math::inside(-0.0F));
    CHECK_FALSE(math::inside(-std::numeric_limits<float>::denorm_min()));
    CHECK_FALSE(math::inside(std::numeric_limits<float>::quiet_NaN()));
}
