#include "core/pipeline/frame.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/soup_scene.hpp"

using namespace hs;

namespace {

std::shared_ptr<scene::Scene> one_triangle() {
    const tests::Soup soup{{{0, 0, 0, 1}}, {{1, 0, 0, 1}}, {{0, 1, 0, 1}}};
    return std::make_shared<scene::Scene>(*tests::soup_scene(soup, {}));
}

std::shared_ptr<const scene::Texture> white_texel() {
    auto texture = std::make_shared<scene::Texture>();
    texture->texels = {glm::vec4{1.0F}};
    return texture;
}

} // namespace

TEST_CASE("an object's overrides hold for its draw alone", "[pipeline]") {
    const auto scene = one_triangle();
    scene->objects.push_back(scene->objects.front());
    scene->objects[1].overrides.emplace_back("depth.write", scene::SettingValue{false});
    const pipeline::Frame frame(scene);
    REQUIRE(frame.calls().size() == 2);
    CHECK(frame.calls()[0].settings.depth_write);
    CHECK_FALSE(frame.calls()[1].settings.depth_write);
    CHECK(frame.calls()[1].object == 1);
}

TEST_CASE("a draw interpolates only what its shading reads", "[pipeline]") {
    const auto scene = one_triangle();
    CHECK(pipeline::Frame(scene).calls()[0].vertex.layout.count == 4);

    scene->settings.shading = scene::Shading::phong;
    CHECK(pipeline::Frame(scene).calls()[0].vertex.layout.count == 10);

    scene::Material material;
    material.texture = white_texel();
    scene->materials.push_back(material);
    scene->objects[0].material = 0;
    CHECK(pipeline::Frame(scene).calls()[0].vertex.layout.count == 12);
    CHECK(pipeline::Frame(scene).calls()[0].vertex.shading.texture == material.texture.get());
}

TEST_CASE("a mesh without texture coordinates is drawn untextured", "[pipeline]") {
    const auto scene = one_triangle();
    auto mesh = std::make_shared<scene::Mesh>(*scene->objects[0].mesh);
    mesh->uvs.clear();
    scene->objects[0].mesh = mesh;
    scene::Material material;
    material.texture = white_texel();
    scene->materials.push_back(material);
    scene->objects[0].material = 0;
    CHECK(pipeline::Frame(scene).calls()[0].vertex.shading.texture == nullptr);
}

TEST_CASE("the aspect of the picture is the viewport's, not the image's", "[pipeline]") {
    const auto scene = one_triangle();
    scene->camera.projection.kind = scene::ProjectionKind::perspective;
    scene->settings.width = 200;
    scene->settings.height = 100;
    scene->settings.viewport_choice = PixelRect{50, 0, 150, 100};
    const pipeline::Frame frame(scene);
    const glm::mat4& m = frame.calls()[0].vertex.transforms.projection.matrix;
    CHECK(m[0][0] == m[1][1]);
}
