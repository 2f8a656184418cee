#include "core/math/varyings.hpp"

#include "tests/support/catch.hpp"

using namespace hs;

TEST_CASE("what is set in the varyings is read back from there", "[math]") {
    math::Varyings v;
    v.set(0, glm::vec4{1.0F, 2.0F, 3.0F, 4.0F});
    v.set(4, glm::vec2{5.0F, 6.0F});
    v.set(6, glm::vec3{7.0F, 8.0F, 9.0F});
    CHECK(v.color() == glm::vec4{1.0F, 2.0F, 3.0F, 4.0F});
    CHECK(v.vec2_at(4) == glm::vec2{5.0F, 6.0F});
    CHECK(v.vec3_at(6) == glm::vec3{7.0F, 8.0F, 9.0F});
    for (int i = 0; i < 9; ++i) {
        CHECK(v[i] == static_cast<float>(i + 1));
    }
    CHECK(v[9] == 0.0F);
}
