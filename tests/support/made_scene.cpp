#include "tests/support/made_scene.hpp"

#include "core/scene/triangulate.hpp"

namespace hs::tests {

std::shared_ptr<scene::Scene>
clip_space_scene(const std::vector<glm::vec4>& positions, int width, int height) {
    auto mesh = std::make_shared<scene::Mesh>();
    mesh->positions = positions;
    mesh->polygon_start.push_back(0);
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        mesh->polygon_vertices.push_back(i);
        if (i % 3 == 2) {
            mesh->polygon_start.push_back(i + 1);
        }
    }
    scene::finish_mesh(*mesh);

    auto made = std::make_shared<scene::Scene>();
    made->settings.width = width;
    made->settings.height = height;
    made->camera.projection.kind = scene::ProjectionKind::identity;
    scene::Object object;
    object.name = "triangles";
    object.mesh = mesh;
    made->objects.push_back(object);
    return made;
}

std::shared_ptr<scene::Scene> stacked_scene(int count, int width, int height) {
    std::vector<glm::vec4> positions;
    for (int i = 0; i < count; ++i) {
        positions.insert(
            positions.end(),
            {{-1.0F, -1.0F, 0.0F, 1.0F}, {3.0F, -1.0F, 0.0F, 1.0F}, {-1.0F, 3.0F, 0.0F, 1.0F}}
        );
    }
    return clip_space_scene(positions, width, height);
}

} // namespace hs::tests
