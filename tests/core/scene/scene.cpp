#include "core/scene/scene.hpp"

#include "tests/support/catch.hpp"

#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

using namespace hs::scene;

namespace {

TransformStep translate(const glm::vec3& v) {
    return {.kind = TransformStep::Kind::translate, .vector = v};
}
TransformStep scale(const glm::vec3& v) {
    return {.kind = TransformStep::Kind::scale, .vector = v};
}
TransformStep rotate(const glm::vec3& axis, float degrees) {
    return {.kind = TransformStep::Kind::rotate, .vector = axis, .degrees = degrees};
}

glm::mat4 matrix_of(const std::vector<TransformStep>& steps) {
    Object object;
    object.transform = steps;
    return object_to_world(object);
}

void check_near(const glm::mat4& a, const glm::mat4& b) {
    for (int i = 0; i < 16; ++i) {
        CHECK(a[i / 4][i % 4] == Approx(b[i / 4][i % 4]).margin(1e-6));
    }
}

} // namespace

TEST_CASE("no steps are the identity", "[unit][scene]") {
    CHECK(matrix_of({}) == glm::mat4{1.0F});
}

TEST_CASE("elementary transforms are those of GLM", "[unit][scene]") {
    const glm::mat4 one{1.0F};
    const glm::vec3 v{1.0F, -2.0F, 3.0F};
    CHECK(matrix_of({translate(v)}) == glm::translate(one, v));
    CHECK(matrix_of({scale(v)}) == glm::scale(one, v));
    for (int sixteenth = -32; sixteenth <= 32; ++sixteenth) {
        const float degrees = static_cast<float>(sixteenth) * 22.5F;
        INFO(degrees);
        check_near(matrix_of({rotate(v, degrees)}), glm::rotate(one, glm::radians(degrees), v));
    }
}

TEST_CASE("steps apply right to left, like the matrices they are", "[unit][scene]") {
    const glm::mat4 m = matrix_of({translate({10.0F, 0.0F, 0.0F}), scale({2.0F, 2.0F, 2.0F})});
    CHECK(m * glm::vec4{1.0F, 1.0F, 1.0F, 1.0F} == glm::vec4{12.0F, 2.0F, 2.0F, 1.0F});
    TransformStep matrix{.kind = TransformStep::Kind::matrix};
    matrix.matrix[3] = {5.0F, 6.0F, 7.0F, 1.0F};
    CHECK(matrix_of({matrix}) == matrix.matrix);
}

TEST_CASE("quarter turns are exact", "[unit][scene]") {
    const glm::vec4 x{1.0F, 0.0F, 0.0F, 1.0F};
    const glm::vec3 z{0.0F, 0.0F, 1.0F};
    CHECK(matrix_of({rotate(z, 90.0F)}) * x == glm::vec4{0.0F, 1.0F, 0.0F, 1.0F});
    CHECK(matrix_of({rotate(z, 180.0F)}) * x == glm::vec4{-1.0F, 0.0F, 0.0F, 1.0F});
    CHECK(matrix_of({rotate(z, -90.0F)}) * x == glm::vec4{0.0F, -1.0F, 0.0F, 1.0F});
    CHECK(matrix_of({rotate(z, 3600.0F)}) == glm::mat4{1.0F});
}

TEST_CASE("overrides of an object change its settings only", "[unit][scene]") {
    Scene scene;
    Object object;
    object.overrides.emplace_back("depth.write", SettingValue{false});
    object.overrides.emplace_back("cull", SettingValue{std::string{"back"}});
    const Settings settings = object_settings(scene, object);
    CHECK_FALSE(settings.depth_write);
    CHECK(settings.cull == CullFace::back);
    CHECK(object_settings(scene, Object{}) == scene.settings);
}

TEST_CASE("instances count their triangles each", "[unit][scene]") {
    const auto mesh = std::make_shared<Mesh>();
    mesh->triangles.resize(5);
    Scene scene;
    scene.objects.resize(3);
    for (Object& object : scene.objects) {
        object.mesh = mesh;
    }
    CHECK(triangle_count(scene) == 15);
}
