#include "core/math/interpolate.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

using namespace hs;

TEST_CASE("interpolation between two values starts at the first", "[math]") {
    CHECK(math::interpolate(3.0F, 7.0F, 0.0F) == 3.0F);
    CHECK(math::interpolate(3.0F, 7.0F, 0.25F) == 4.0F);
    CHECK(math::interpolate(3.0F, 7.0F, 1.0F) == 7.0F);
}

TEST_CASE("interpolation over a triangle meets its vertices", "[math]") {
    CHECK(math::interpolate(1.0F, 2.0F, 5.0F, 0.0F, 0.0F) == 1.0F);
    CHECK(math::interpolate(1.0F, 2.0F, 5.0F, 1.0F, 0.0F) == 2.0F);
    CHECK(math::interpolate(1.0F, 2.0F, 5.0F, 0.0F, 1.0F) == 5.0F);
}

TEST_CASE("equal values are interpolated exactly, whatever the weights", "[math]") {
    tests::Random random(1);
    int wrong = 0;
    for (int i = 0; i < 10'000; ++i) {
        const float v = random.between(-1.0e6F, 1.0e6F);
        const float a = random.between(-2.0F, 2.0F);
        const float b = random.between(-2.0F, 2.0F);
        wrong += math::interpolate(v, v, a) == v ? 0 : 1;
        wrong += math::interpolate(v, v, v, a, b) == v ? 0 : 1;
    }
    CHECK(wrong == 0);
}
