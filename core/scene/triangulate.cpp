#include "core/scene/triangulate.hpp"

#include "core/base/check.hpp"
#include "core/scene/planar_polygon.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace hs::scene {

namespace {

using Corners = std::span<const std::uint32_t>;

void add_fan(Mesh& mesh, Corners corners, std::size_t from) {
    const std::size_t count = corners.size();
    for (std::size_t i = 1; i + 1 < count; ++i) {
        mesh.triangles.push_back(
            {corners[from], corners[(from + i) % count], corners[(from + i + 1) % count]}
        );
    }
}

/// A new vertex whose attributes are the weighted means of the corners'. Weights are those of the
/// points after division by w; divided by w they become weights of the homogeneous corners, along
/// which attributes are linear.
std::uint32_t add_weighted_vertex(Mesh& mesh, Corners corners, std::vector<double> weights) {
    double sum = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        weights[i] /= static_cast<double>(mesh.positions[corners[i]].w);
        sum += weights[i];
    }
    const auto add_mean = [&](auto& attribute) {
        if (attribute.empty()) {
            return;
        }
        auto mean = attribute[corners[0]];
        for (std::size_t i = 1; i < corners.size(); ++i) {
            // Difference form: a constant attribute stays exactly what it is.
            mean += static_cast<float>(weights[i] / sum) *
                    (attribute[corners[i]] - attribute[corners[0]]);
        }
        attribute.push_back(mean);
    };
    const auto index = static_cast<std::uint32_t>(mesh.positions.size());
    add_mean(mesh.positions);
    add_mean(mesh.normals);
    add_mean(mesh.colors);
    add_mean(mesh.uvs);
    if (!mesh.file_vertex.empty()) {
        mesh.file_vertex.push_back(1 + *std::ranges::max_element(mesh.file_vertex));
    }
    return index;
}

void add_kernel_fan(Mesh& mesh, Corners corners, std::uint32_t kernel_vertex) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        mesh.triangles.push_back({corners[i], corners[(i + 1) % corners.size()], kernel_vertex});
    }
}

void triangulate_polygon(Mesh& mesh, Corners corners) {
    HS_CHECK(corners.size() >= 3, "a polygon has at least three corners");
    if (corners.size() == 3) {
        mesh.triangles.push_back({corners[0], corners[1], corners[2]});
        return;
    }
    std::vector<glm::vec4> points;
    points.reserve(corners.size());
    for (const std::uint32_t vertex : corners) {
        points.push_back(mesh.positions[vertex]);
    }
    const std::optional<PlanarPolygon> polygon = lay_flat(points);
    if (!polygon) {
        add_fan(mesh, corners, 0);
    } else if (const auto corner = find_fan_corner(*polygon)) {
        add_fan(mesh, corners, *corner);
    } else if (const auto point = find_kernel_point(*polygon)) {
        const std::vector<double> weights = mean_value_weights(*polygon, *point);
        add_kernel_fan(mesh, corners, add_weighted_vertex(mesh, corners, weights));
    } else {
        for (const auto& [a, b, c] : clip_ears(*polygon)) {
            mesh.triangles.push_back({corners[a], corners[b], corners[c]});
        }
    }
}

void triangulate(Mesh& mesh) {
    mesh.triangles.clear();
    mesh.triangle_polygon.clear();
    mesh.triangles.reserve(mesh.polygon_vertices.size());
    mesh.triangle_polygon.reserve(mesh.polygon_vertices.size());
    const std::span all = mesh.polygon_vertices;
    for (std::size_t i = 0; i < mesh.polygon_count(); ++i) {
        const std::uint32_t start = mesh.polygon_start[i];
        triangulate_polygon(mesh, all.subspan(start, mesh.polygon_start[i + 1] - start));
        mesh.triangle_polygon.resize(mesh.triangles.size(), static_cast<std::uint32_t>(i));
    }
}

/// Where a vertex lies after division by w; corners at w <= 0 lie nowhere and count as directions.
glm::dvec3 place(const glm::vec4& position) {
    const glm::dvec4 p{position};
    return p.w > 0.0 ? glm::dvec3{p} / p.w : glm::dvec3{p};
}

/// Vertices that were split because of their texture coordinates share the normal of the vertex in
/// the file.
std::vector<std::uint32_t> shared_vertices(const Mesh& mesh) {
    if (!mesh.file_vertex.empty()) {
        return mesh.file_vertex;
    }
    std::vector<std::uint32_t> identity(mesh.positions.size());
    for (std::size_t i = 0; i < identity.size(); ++i) {
        identity[i] = static_cast<std::uint32_t>(i);
    }
    return identity;
}

glm::vec3 unit_or_z(const glm::dvec3& v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    // Divided first: squares of huge or tiny numbers leave the range of double.
    return largest > 0.0 ? glm::vec3{glm::normalize(v / largest)} : glm::vec3{0.0F, 0.0F, 1.0F};
}

/// The cross product of two edges is twice the area long: its sum weighs each triangle's normal by
/// area.
std::vector<glm::vec3> area_weighted_normals(const Mesh& mesh) {
    const std::vector<std::uint32_t> shared = shared_vertices(mesh);
    const std::size_t count =
        shared.empty() ? 0 : std::size_t{1} + *std::ranges::max_element(shared);
    std::vector<glm::dvec3> sums(count, glm::dvec3{0.0});
    for (const TriangleIndices& t : mesh.triangles) {
        const glm::dvec3 a = place(mesh.positions[t.a]);
        const glm::dvec3 normal =
            glm::cross(place(mesh.positions[t.b]) - a, place(mesh.positions[t.c]) - a);
        for (int corner = 0; corner < 3; ++corner) {
            sums[shared[t[corner]]] += normal;
        }
    }
    std::vector<glm::vec3> normals;
    normals.reserve(shared.size());
    for (const std::uint32_t vertex : shared) {
        normals.push_back(unit_or_z(sums[vertex]));
    }
    return normals;
}

/// Normals of length 0 are replaced by computed ones.
void normalize_normals(Mesh& mesh) {
    const auto is_zero = [](const glm::vec3& n) { return n == glm::vec3{0.0F}; };
    std::vector<glm::vec3> computed;
    if (std::ranges::any_of(mesh.normals, is_zero)) {
        computed = area_weighted_normals(mesh);
    }
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        glm::vec3& n = mesh.normals[i];
        n = is_zero(n) ? computed[i] : unit_or_z(glm::dvec3{n});
    }
}

} // namespace

void finish_mesh(Mesh& mesh) {
    triangulate(mesh);
    if (mesh.normals.empty()) {
        mesh.normals = area_weighted_normals(mesh);
    } else {
        normalize_normals(mesh);
    }
}

void fit_to_unit_sphere(Mesh& mesh) {
    if (mesh.positions.empty()) {
        return;
    }
    glm::dvec3 low = place(mesh.positions[0]);
    glm::dvec3 high = low;
    for (const glm::vec4& position : mesh.positions) {
        low = glm::min(low, place(position));
        high = glm::max(high, place(position));
    }
    const glm::dvec3 center = 0.5 * (low + high);
    double radius = 0.0;
    for (const glm::vec4& position : mesh.positions) {
        radius = std::max(radius, glm::length(place(position) - center));
    }
    if (!(radius > 0.0)) {
        return;
    }
    for (glm::vec4& position : mesh.positions) {
        const auto w = static_cast<double>(position.w);
        const glm::dvec3 moved = (glm::dvec3{position} - center * w) / radius;
        position = glm::vec4{glm::vec3{moved}, position.w};
    }
}

} // namespace hs::scene
