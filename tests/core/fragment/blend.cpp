#include "core/fragment/blend.hpp"

#include "tests/support/catch.hpp"

using namespace hs;

TEST_CASE("blending is source alpha over destination", "[fragment][blend]") {
    const glm::vec4 src{1.0F, 0.5F, 0.0F, 0.25F};
    const glm::vec4 dst{0.0F, 0.5F, 1.0F, 0.5F};
    CHECK(fragment::blend_over(src, dst) == glm::vec4{0.25F, 0.5F, 0.75F, 0.625F});
}

TEST_CASE("an opaque fragment covers, an invisible one leaves the pixel", "[fragment][blend]") {
    const glm::vec4 dst{0.1F, 0.2F, 0.3F, 0.4F};
    CHECK(fragment::blend_over({0.5F, 0.6F, 0.7F, 1.0F}, dst) == glm::vec4{0.5F, 0.6F, 0.7F, 1.0F});
    CHECK(fragment::blend_over({0.5F, 0.6F, 0.7F, 0.0F}, dst) == dst);
}

TEST_CASE("over depends on the order", "[fragment][blend]") {
    const glm::vec4 red{1.0F, 0.0F, 0.0F, 0.5F};
    const glm::vec4 blue{0.0F, 0.0F, 1.0F, 0.5F};
    const glm::vec4 black{0.0F, 0.0F, 0.0F, 1.0F};
    CHECK(
        fragment::blend_over(blue, fragment::blend_over(red, black)) ==
        glm::vec4{0.25F, 0.0F, 0.5F, 1.0F}
    );
    CHECK(
        fragment::blend_over(red, fragment::blend_over(blue, black)) ==
        glm::vec4{0.5F, 0.0F, 0.25F, 1.0F}
    );
}
