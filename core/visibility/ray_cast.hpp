// Ray casting: the two loops swapped. For every pixel, every triangle; the nearest hit is kept.
//
// Appel, Some Techniques for Shading Machine Renderings of Solids, 1968. Triangles are met by
// scaled volumes in double (Kensler and Shirley 2006; Woop, Benthin and Wald 2013): neighbors
// compute the volume of a shared edge with opposite sign to the bit, so no ray slips between them.
#pragma once

#include "core/visibility/sweep_trace.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <span>

namespace hs::visibility {

/// From the near plane (t = 0) to the far plane (t = 1) of the view volume, in world space.
struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0};
};

/// Where the view volume begins and ends: NDC depths of the near and the far plane.
struct NdcDepths {
    double near = -1.0;
    double far = 1.0;
};

/// Through a point of the window, in pixels from the top-left corner.
[[nodiscard]] Ray ray_through(
    const glm::dvec2& window,
    const glm::dvec2& window_size,
    const glm::dmat4& clip_to_world,
    const NdcDepths& depths
);

using RayTriangle = std::array<glm::dvec3, 3>;

/// A ray's meeting with the plane of a triangle.
struct RayMeeting {
    bool hit = false;
    double t = 0.0;          ///< along the ray
    glm::dvec3 weights{0.0}; ///< of the vertices where it meets: negative outside
};

/// Volumes of the ray with each edge, that of a vertex with the edge opposite: all of one sign iff
/// it passes between them.
[[nodiscard]] glm::dvec3 ray_volumes(const Ray& ray, const RayTriangle& triangle);

/// Both sides are hit; edges belong to the triangle. A triangle seen edge-on is not hit.
[[nodiscard]] RayMeeting meet(const Ray& ray, const RayTriangle& triangle);

struct RayCast {
    Ray ray;
    std::int32_t nearest = -1; ///< of the triangles asked so far; −1: none
    RayMeeting meeting{};      ///< with the nearest
};

/// Questions for a whole picture.
[[nodiscard]] inline double estimate_ray_cast(int width, int height, std::size_t triangles) {
    return static_cast<double>(width) * height * static_cast<double>(triangles);
}

/// One pixel's ray. Of equally near triangles the first stays.
template <SweepSink<RayCast> Sink>
[[nodiscard]] RayCast cast_ray(const Ray& ray, std::span<const RayTriangle> triangles, Sink& sink) {
    RayCast cast{.ray = ray};
    sink.sweep_step({.kind = SweepEventKind::cast}, cast);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const RayMeeting meeting = meet(ray, triangles[i]);
        SweepEvent event{
            .kind = SweepEventKind::meet,
            .verdict = meeting.hit && meeting.t >= 0.0 && meeting.t <= 1.0,
            .polygon = static_cast<std::int32_t>(i),
            .value = meeting.t,
            .weights = meeting.weights};
        sink.sweep_step(event, cast);
        if (!event.verdict) {
            continue;
        }
        event.kind = SweepEventKind::keep;
        event.other = cast.nearest;
        event.other_value =
            cast.nearest < 0 ? std::numeric_limits<double>::infinity() : cast.meeting.t;
        event.verdict = event.value < event.other_value;
        if (event.verdict) {
            cast.nearest = event.polygon;
            cast.meeting = meeting;
        }
        sink.sweep_step(event, cast);
    }
    return cast;
}

} // namespace hs::visibility
