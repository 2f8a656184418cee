#include "core/pipeline/window_polygons.hpp"

#include "core/geometry/facing.hpp"
#include "core/pipeline/narration.hpp"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <optional>

namespace hs::pipeline {
namespace {

/// Weights of a point of a triangle's plane among its vertices, in clip coordinates. Solved for,
/// not interpolated along with the point: of a triangle that reaches far beyond the view volume
/// floats would not be fine enough.
class Weights {
public:
    Weights(const DrawCall& call, const scene::TriangleIndices& indices) {
        glm::dmat3 vertices;
        for (int corner = 0; corner < 3; ++corner) {
            vertices[corner] = xyw(call.vertices[indices[corner]].clip);
        }
        if (glm::determinant(vertices) != 0.0) { // else it is edge-on, and left out as unseen
            to_weights_ = glm::inverse(vertices);
        }
    }

    [[nodiscard]] glm::dvec3 operator()(const math::ClipPosition& p) const {
        return to_weights_ * xyw(p);
    }

private:
    /// A triangle that is seen is not edge-on: x, y and w tell its points apart.
    [[nodiscard]] static glm::dvec3 xyw(const math::ClipPosition& p) {
        return glm::dvec3{glm::vec3{p.x, p.y, p.w}};
    }

    glm::dmat3 to_weights_{1.0};
};

/// The triangle within the view volume. No corners: nothing is left.
geometry::ClipPolygon clipped(const DrawCall& call, const scene::TriangleIndices& indices) {
    geometry::ClipPolygon polygon;
    unsigned crossed = 0;
    unsigned outside = ~0U;
    for (int corner = 0; corner < 3; ++corner) {
        const ShadedVertex& vertex = call.vertices[indices[corner]];
        polygon.add({vertex.clip, {}});
        crossed |= vertex.outcode;
        outside &= vertex.outcode;
    }
    if (!call.settings.clip_enabled) {
        return polygon;
    }
    NullTrace nothing;
    return outside != 0 ? geometry::ClipPolygon{}
                        : geometry::clip_polygon(
                              polygon, call.volume, static_cast<geometry::Outcode>(crossed), nothing
                          );
}

/// Whether culling and the snapped area leave any of the triangles it is fanned into.
bool is_seen(const DrawCall& call, const std::vector<geometry::WindowVertex>& window) {
    for (std::size_t k = 1; k + 1 < window.size(); ++k) {
        const std::int64_t area =
            geometry::doubled_area(window[0].fixed, window[k].fixed, window[k + 1].fixed);
        const auto verdict =
            geometry::face_verdict(area, call.settings.front_face, call.settings.cull);
        if (verdict == geometry::TriangleVerdict::drawn) {
            return true;
        }
    }
    return false;
}

glm::dvec3 window_position(const DrawCall& call, const geometry::WindowVertex& vertex) {
    const bool reversed = call.settings.depth_convention == scene::DepthConvention::reversed;
    const auto depth = static_cast<double>(vertex.window.depth);
    return {
        static_cast<double>(vertex.window.x),
        static_cast<double>(vertex.window.y),
        reversed ? 1.0 - depth : depth};
}

/// Nothing when nothing is seen of it.
std::optional<visibility::WindowPolygon>
window_polygon(const DrawCall& call, const scene::TriangleIndices& indices) {
    const geometry::ClipPolygon polygon = clipped(call, indices);
    const Weights weights(call, indices);
    std::vector<geometry::WindowVertex> window;
    visibility::WindowPolygon result;
    for (int i = 0; i < polygon.count; ++i) {
        const geometry::WindowVertex v = geometry::to_window(polygon[i].position, call.viewport);
        if (v.status != geometry::WindowStatus::placed) {
            return std::nullopt;
        }
        window.push_back(v);
        result.corners.push_back(
            {.position = window_position(call, v),
             .weights = weights(polygon[i].position) * static_cast<double>(v.inv_w)}
        );
    }
    return is_seen(call, window) ? std::optional{std::move(result)} : std::nullopt;
}

/// How many triangles from `first` on belong to the same face.
std::uint32_t triangles_of_face(const scene::Mesh& mesh, std::uint32_t first) {
    std::uint32_t last = first + 1;
    while (last < mesh.triangles.size() &&
           mesh.triangle_polygon[last] == mesh.triangle_polygon[first]) {
        ++last;
    }
    return last - first;
}

/// Whether every corner turns the same way and lies in the plane of the others, up to rounding.
bool is_flat_and_convex(const std::vector<visibility::Corner<visibility::WindowSpace>>& corners) {
    const std::size_t count = corners.size();
    glm::dvec3 normal{0.0}; // Newell's sum
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3& a = corners[i].position;
        const glm::dvec3& b = corners[(i + 1) % count].position;
        normal += glm::cross(a - corners[0].position, b - corners[0].position);
    }
    if (normal.z == 0.0) {
        return false;
    }
    constexpr double flat = 1.0e-5; // of the depth range
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3& a = corners[i].position;
        const glm::dvec3& b = corners[(i + 1) % count].position;
        const glm::dvec3& c = corners[(i + 2) % count].position;
        const double turn = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
        const double off_plane = glm::dot(normal, b - corners[0].position) / normal.z;
        if (turn * normal.z < 0.0 || std::fabs(off_plane) > flat) {
            return false;
        }
    }
    return true;
}

/// The face of a triangle as one polygon, where it can be.
std::optional<visibility::WindowPolygon> whole_face(const DrawCall& call, std::uint32_t triangle) {
    const scene::Mesh& mesh = *call.vertex.mesh;
    const std::uint32_t face = mesh.triangle_polygon[triangle];
    visibility::WindowPolygon result;
    result.triangle_count = triangles_of_face(mesh, triangle);
    for (std::uint32_t i = 0; i < result.triangle_count; ++i) {
        const auto part = window_polygon(call, call.triangles()[triangle + i]);
        if (!part || part->corners.size() != 3) {
            return std::nullopt;
        }
    }
    for (std::uint32_t k = mesh.polygon_start[face]; k < mesh.polygon_start[face + 1]; ++k) {
        const ShadedVertex& vertex = call.vertices[mesh.polygon_vertices[k]];
        if (vertex.outcode != 0 || vertex.window.status != geometry::WindowStatus::placed) {
            return std::nullopt;
        }
        result.corners.push_back({.position = window_position(call, vertex.window), .weights = {}});
    }
    const bool whole = result.triangle_count + 2 == result.corners.size();
    return whole && is_flat_and_convex(result.corners) ? std::optional{std::move(result)}
                                                       : std::nullopt;
}

} // namespace

WindowPolygons window_polygons(const Frame& frame, Faces faces) {
    WindowPolygons result;
    std::uint32_t first = 0; // of the object, over the whole frame
    for (const DrawCall& call : frame.calls()) {
        const auto count = static_cast<std::uint32_t>(call.triangles().size());
        for (std::uint32_t i = 0; i < count;) {
            std::optional<visibility::WindowPolygon> polygon;
            const bool several =
                faces == Faces::whole && triangles_of_face(*call.vertex.mesh, i) > 1;
            if (several) {
                polygon = whole_face(call, i);
            }
            if (!polygon) {
                polygon = window_polygon(call, call.triangles()[i]);
            }
            if (!polygon) {
                result.unseen.push_back({call.object, i});
                ++i;
                continue;
            }
            polygon->triangle = first + i;
            i += polygon->triangle_count;
            result.polygons.push_back(*std::move(polygon));
        }
        first += count;
    }
    return result;
}

} // namespace hs::pipeline
