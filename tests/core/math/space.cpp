#include "core/math/space.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

#include <algorithm>
#include <cmath>

using namespace hs;

namespace {

glm::mat4 random_matrix(tests::Random& random) {
    glm::mat4 m{1.0F};
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            m[column][row] = random.between(-2.0F, 2.0F);
        }
    }
    return m;
}

math::ObjectPosition random_position(tests::Random& random) {
    const auto coordinate = [&] { return random.between(-4.0F, 4.0F); };
    return {coordinate(), coordinate(), coordinate(), coordinate()};
}

float largest_difference(const glm::vec4& a, const glm::vec4& b) {
    float largest = 0.0F;
    for (int i = 0; i < 4; ++i) {
        largest = std::max(largest, std::fabs(a[i] - b[i]));
    }
    return largest;
}

} // namespace

TEST_CASE("a transform is GLM's matrix times vector", "[math]") {
    tests::Random random(2);
    float worst = 0.0F;
    for (int i = 0; i < 1000; ++i) {
        const math::Transform<math::ObjectSpace, math::WorldSpace> t{random_matrix(random)};
        const math::ObjectPosition p = random_position(random);
        const glm::vec4 expected = t.matrix * math::to_vec4(p);
        worst = std::max(worst, largest_difference(math::to_vec4(t(p)), expected));
    }
    CHECK(worst <= 8.0F * 32.0F * 0x1p-24F); // four products of up to 8, added in another order
}

TEST_CASE("a composed transform applies the inner one first", "[math]") {
    tests::Random random(3);
    float worst = 0.0F;
    for (int i = 0; i < 1000; ++i) {
        const math::Transform<math::ObjectSpace, math::WorldSpace> inner{random_matrix(random)};
        const math::Transform<math::WorldSpace, math::EyeSpace> outer{random_matrix(random)};
        const math::ObjectPosition p = random_position(random);
        const math::EyePosition stepwise = outer(inner(p));
        const math::EyePosition at_once = math::compose(outer, inner)(p);
        worst =
            std::max(worst, largest_difference(math::to_vec4(stepwise), math::to_vec4(at_once)));
    }
    CHECK(worst <= 16.0F * 256.0F * 0x1p-24F);
}

TEST_CASE("the identity changes nothing", "[math]") {
    const math::ObjectPosition p{1.0F, -2.0F, 3.5F, 0.25F};
    const math::Transform<math::ObjectSpace, math::WorldSpace> identity;
    CHECK(math::to_vec4(identity(p)) == math::to_vec4(p));
}
