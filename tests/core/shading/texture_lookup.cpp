#include "core/shading/texture_lookup.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

#include <limits>

using namespace hs;

TEST_CASE("a texel's square is closed at its low side, open at its high side", "[texture]") {
    CHECK(shading::repeat_texel(0.0F, 4) == 0);
    CHECK(shading::repeat_texel(0.2499F, 4) == 0);
    CHECK(shading::repeat_texel(0.25F, 4) == 1);
    CHECK(shading::repeat_texel(0.75F, 4) == 3);
    CHECK(shading::repeat_texel(0.9999F, 4) == 3);
}

TEST_CASE("the image repeats in both directions", "[texture]") {
    CHECK(shading::repeat_texel(1.0F, 4) == 0);
    CHECK(shading::repeat_texel(2.5F, 4) == 2);
    CHECK(shading::repeat_texel(-0.25F, 4) == 3);
    CHECK(shading::repeat_texel(-1.0F, 4) == 0);
    for (int k = -5; k <= 5; ++k) {
        CHECK(shading::repeat_texel(0.625F + static_cast<float>(k), 4) == 2);
    }
}

TEST_CASE("any coordinate addresses a texel of the image", "[texture]") {
    const float inf = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float tiny = std::numeric_limits<float>::denorm_min();
    CHECK(shading::repeat_texel(nan, 7) == 0);
    CHECK(shading::repeat_texel(inf, 7) == 0);
    CHECK(shading::repeat_texel(-inf, 7) == 0);
    CHECK(shading::repeat_texel(-tiny, 7) == 6); // its fraction rounds up to 1
    CHECK(shading::repeat_texel(3.0e38F, 7) == 0);
    tests::Random random(3);
    int outside = 0;
    for (int i = 0; i < 100'000; ++i) {
        const int size = 1 + static_cast<int>(random.below(5000));
        const float reach = random.one_in(2) ? 4.0F : 1.0e9F;
        const int texel = shading::repeat_texel(random.between(-reach, reach), size);
        outside += texel >= 0 && texel < size ? 0 : 1;
    }
    CHECK(outside == 0);
}

TEST_CASE("u runs along rows, v down the columns", "[texture]") {
    scene::Texture texture;
    texture.width = 2;
    texture.height = 2;
    texture.texels = {glm::vec4{1.0F}, glm::vec4{2.0F}, glm::vec4{3.0F}, glm::vec4{4.0F}};
    CHECK(shading::sample_nearest(texture, {0.25F, 0.25F}) == glm::vec4{1.0F});
    CHECK(shading::sample_nearest(texture, {0.75F, 0.25F}) == glm::vec4{2.0F});
    CHECK(shading::sample_nearest(texture, {0.25F, 0.75F}) == glm::vec4{3.0F});
    CHECK(shading::sample_nearest(texture, {0.75F, 0.75F}) == glm::vec4{4.0F});
}
