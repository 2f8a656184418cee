#include "core/trace/visibility_growth.hpp"

#include <memory>

namespace hs::trace {
namespace {

/// `part` of every `whole` polygons with their triangles, spread evenly; no lines and points.
std::shared_ptr<const scene::Mesh>
thinned(const scene::Mesh& mesh, std::size_t part, std::size_t whole) {
    auto result = std::make_shared<scene::Mesh>(mesh);
    result->polygon_start.assign(1, 0);
    result->polygon_vertices.clear();
    result->triangles.clear();
    result->triangle_polygon.clear();
    result->lines.clear();
    result->points.clear();
    std::size_t t = 0;
    for (std::size_t p = 0; p < mesh.polygon_count(); ++p) {
        const bool kept = (p + 1) * part / whole > p * part / whole;
        for (; t < mesh.triangles.size() && mesh.triangle_polygon[t] == p; ++t) {
            if (kept) {
                result->triangles.push_back(mesh.triangles[t]);
                const std::size_t number = result->polygon_count();
                result->triangle_polygon.push_back(static_cast<std::uint32_t>(number));
            }
        }
        if (kept) {
            const auto corner = [&mesh](std::uint32_t k) {
                return mesh.polygon_vertices.begin() + static_cast<std::ptrdiff_t>(k);
            };
            result->polygon_vertices.insert(
                result->polygon_vertices.end(),
                corner(mesh.polygon_start[p]),
                corner(mesh.polygon_start[p + 1])
            );
            const std::size_t end = result->polygon_vertices.size();
            result->polygon_start.push_back(static_cast<std::uint32_t>(end));
        }
    }
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
