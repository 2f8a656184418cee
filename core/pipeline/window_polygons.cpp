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
        to_weights_ = glm::inverse(vertices);
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

/// Nothing when nothing is seen of it.
std::optional<visibility::WindowPolygon>
window_polygon(const DrawCall& call, const scene::TriangleIndices& indices) {
    const geometry::ClipPolygon polygon = clipped(call, indices);
    const Weights weights(call, indices);
    const bool reversed = call.settings.depth_convention == scene::DepthConvention::reversed;
    std::vector<geometry::WindowVertex> window;
    visibility::WindowPolygon result;
    for (int i = 0; i < polygon.count; ++i) {
        const geometry::WindowVertex v = geometry::to_window(polygon[i].position, call.viewport);
        if (v.status != geometry::WindowStatus::placed) {
            return std::nullopt;
        }
        window.push_back(v);
        const auto depth = static_cast<double>(v.window.depth);
        result.corners.push_back(
            {.position =
                 {static_cast<double>(v.window.x),
                  static_cast<double>(v.window.y),
                  reversed ? 1.0 - depth : depth},
             .weights = weights(polygon[i].position) * static_cast<double>(v.inv_w)}
        );
    }
    return is_seen(call, window) ? std::optional{std::move(result)} : std::nullopt;
}

} // namespace

WindowPolygons window_polygons(const Frame& frame) {
    WindowPolygons result;
    std::uint32_t number = 0;
    for (const DrawCall& call : frame.calls()) {
        for (std::uint32_t i = 0; i < call.triangles().size(); ++i, ++number) {
            if (auto polygon = window_polygon(call, call.triangles()[i])) {
                polygon->triangle = number;
                result.polygons.push_back(*std::move(polygon));
            } else {
                result.unseen.push_back({call.object, i});
            }
        }
    }
    return result;
}

} // namespace hs::pipeline
