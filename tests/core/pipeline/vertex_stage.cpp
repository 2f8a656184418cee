#include "core/pipeline/vertex_stage.hpp"

#include "core/pipeline/frame.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/soup_scene.hpp"

#include <glm/geometric.hpp>

#include <cmath>

using namespace hs;

namespace {

/// One triangle, moved and stretched, seen in perspective.
std::shared_ptr<scene::Scene> stretched() {
    const tests::Soup soup{{{1, 0, 0, 1}}, {{0, 2, 0, 1}}, {{0, 0, 3, 1}}};
    auto scene = std::make_shared<scene::Scene>(*tests::soup_scene(soup, {}));
    scene->camera.projection.kind = scene::ProjectionKind::perspective;
    scene::TransformStep move;
    move.vector = {0.5F, -0.25F, -2.0F};
    scene::TransformStep stretch;
    stretch.kind = scene::TransformStep::Kind::scale;
    stretch.vector = {2.0F, 1.0F, 0.5F};
    scene->objects[0].transform = {move, stretch};
    return scene;
}

} // namespace

TEST_CASE("a vertex passes object, world, eye and clip space in order", "[pipeline][vertex]") {
    const pipeline::Frame frame(stretched());
    const pipeline::VertexInputs& in = frame.calls()[0].vertex;
    const pipeline::VertexWork work = pipeline::run_vertex(in, 1);
    CHECK(work.object == math::ObjectPosition{0.0F, 2.0F, 0.0F, 1.0F});
    CHECK(work.world == math::WorldPosition{0.5F, 1.75F, -2.0F, 1.0F});
    CHECK(work.eye == math::EyePosition{0.5F, 1.75F, -5.0F, 1.0F}); // the camera stands at z = 3
    CHECK(work.clip == in.transforms.projection(work.eye));
    CHECK(work.clip.w == 5.0F);
}

TEST_CASE("normals stay perpendicular under a non-uniform scale", "[pipeline][vertex]") {
    const pipeline::Frame frame(stretched());
    const pipeline::Transforms& t = frame.calls()[0].vertex.transforms;
    const glm::vec3 tangent{1.0F, -2.0F, 0.5F};
    const glm::vec3 normal{2.0F, 1.0F, 0.0F};
    REQUIRE(glm::dot(tangent, normal) == 0.0F);
    const glm::mat3 model_view{t.view.matrix * t.model.matrix};
    CHECK(std::fabs(glm::dot(model_view * tangent, t.normal * normal)) < 1.0e-6F);
    CHECK(std::fabs(glm::dot(model_view * tangent, model_view * normal)) > 1.0F); // the wrong way
}

TEST_CASE("what is squashed flat has a color, but no light that asks for a normal", "[pipeline]") {
    // 1e-13 cubed is a float above zero whose reciprocal is none
    const glm::vec3 scale =
        GENERATE(glm::vec3{0, 1, 1}, glm::vec3{1, 1, 0}, glm::vec3{0}, glm::vec3{1.0e-13F});
    const auto scene = stretched();
    scene->objects[0].transform[1].vector = scale;
    scene->settings.shading = scene::Shading::gouraud;
    scene::Light ambient;
    ambient.kind = scene::LightKind::ambient;
    ambient.color = {0.25F, 0.5F, 0.125F};
    scene->lights = {ambient, {}};
    const pipeline::Frame frame(scene);
    for (std::uint32_t vertex = 0; vertex < 3; ++vertex) {
        const pipeline::VertexWork work = pipeline::run_vertex(frame.calls()[0].vertex, vertex);
        CHECK(work.varyings.color() == glm::vec4{ambient.color, 1.0F});
    }
}

TEST_CASE("vertex colors are multiplied by the material's diffuse color", "[pipeline][vertex]") {
    const tests::Soup soup{
        {{0, 0, 0, 1}, {0.5F, 1.0F, 0.25F, 1.0F}}, {{1, 0, 0, 1}}, {{0, 1, 0, 1}}};
    auto scene = std::make_shared<scene::Scene>(*tests::soup_scene(soup, {}));
    scene::Material material;
    material.diffuse = {0.5F, 0.5F, 1.0F, 0.5F};
    scene->materials.push_back(material);
    scene->objects[0].material = 0;
    const pipeline::Frame frame(scene);
    const pipeline::VertexWork work = pipeline::run_vertex(frame.calls()[0].vertex, 0);
    CHECK(work.varyings.color() == glm::vec4{0.25F, 0.5F, 0.25F, 0.5F});
}

TEST_CASE("only Gouraud shading lights vertices, in a step of its own", "[pipeline][vertex]") {
    for (const Named<scene::Shading>& shading : names<scene::Shading>()) {
        const auto scene = stretched();
        scene->settings.shading = shading.value;
        scene->lights.push_back({});
        const pipeline::Frame frame(scene);
        const pipeline::VertexWork work = pipeline::run_vertex(frame.calls()[0].vertex, 0);
        const bool gouraud = shading.value == scene::Shading::gouraud;
        INFO(shading.name);
        CHECK(work.terms.has_value() == gouraud);
        CHECK(pipeline::steps_per_vertex(shading.value) == (gouraud ? 4 : 3));
        if (gouraud) {
            CHECK(work.varyings.color() == work.terms->color);
        }
    }
}
