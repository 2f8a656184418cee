#include "core/trace/visibility_growth.hpp"

#include "core/scene/triangulate.hpp"

#include <memory>

namespace hs::trace {
namespace {

std::shared_ptr<const scene::Mesh>
thinned(const scene::Mesh& mesh, std::size_t part, std::size_t whole) {
    auto result = std::make_shared<scene::Mesh>(mesh);
    result->polygon_start.assign(1, 0);
    result->polygon_vertices.clear();
    result->triangles.clear();
    result->triangle_polygon.clear();
    result->lines.clear();
    result->points.clear();
    for (std::size_t p = 0; p + 1 < mesh.polygon_start.size(); ++p) {
        if ((p + 1) * part / whole == p * part / whole) {
            continue;
        }
        for (std::size_t k = mesh.polygon_start[p]; k < mesh.polygon_start[p + 1]; ++k) {
            result->polygon_vertices.push_back(mesh.polygon_vertices[k]);
        }
        result->polygon_start.push_back(static_cast<std::uint32_t>(result->polygon_vertices.size())
        );
    }
    scene::finish_mesh(*result);
    return result;
}

} // namespace

scene::Scene thinned(const scene::Scene& scene, std::size_t part, std::size_t whole) {
    scene::Scene result = scene;
    for (scene::Object& object : result.objects) {
        object.mesh = thinned(*object.mesh, part, whole);
    }
    return result;
}

std::vector<GrowthPoint> visibility_growth(const scene::Scene& scene, int points) {
    std::vector<GrowthPoint> growth;
    for (int i = 0; i < points; ++i) {
        const std::size_t whole = std::size_t{1} << static_cast<unsigned>(points - 1 - i);
        const scene::Scene some = thinned(scene, 1, whole);
        GrowthPoint point;
        for (const scene::Object& object : some.objects) {
            point.triangles += object.mesh->triangles.size();
        }
        if (point.triangles > 0) {
            point.outcomes = compare_visibility(some);
            growth.push_back(std::move(point));
        }
    }
    return growth;
}

} // namespace hs::trace
