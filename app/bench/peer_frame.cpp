#include "app/bench/peer_frame.hpp"

namespace hs::bench {

std::optional<PeerFrame>
PeerFrame::create(const peer::Context& mesa, const Subject& subject, const scene::Scene& scene) {
    const scene::Mesh& mesh = *subject.mesh;
    const std::vector<glm::vec3> positions(mesh.positions.begin(), mesh.positions.end());
    std::vector<glm::uvec3> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const scene::TriangleIndices& t : mesh.triangles) {
        triangles.emplace_back(t.a, t.b, t.c);
    }
    std::optional<peer::TimedMesh> timed = peer::TimedMesh::create(
        mesa,
        {.positions = positions, .normals = mesh.normals, .triangles = triangles},
        scene.settings.width,
        scene.settings.height
    );
    if (!timed) {
        return std::nullopt;
    }
    const Light light;
    return PeerFrame(
        std::move(*timed),
        {.clip_from_object = clip_from_object(scene),
         .to_light = light.to_light,
         .color = light.color,
         .ambient = light.ambient}
    );
}

PeerFrame::Agreement PeerFrame::compare(const framebuffer::Framebuffer& ours) const {
    const peer::Image image = mesh_.image();
    Agreement agreement;
    std::size_t at = 0;
    for (int y = 0; y < ours.height(); ++y) {
        for (int x = 0; x < ours.width(); ++x, ++at) {
            const bool covered = ours.depth({x, y}) < 1.0F;
            agreement.covered += covered ? 1U : 0U;
            agreement.differing += covered != (image.depth[at] < 1.0F) ? 1U : 0U;
        }
    }
    return agreement;
}

} // namespace hs::bench
