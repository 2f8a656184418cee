#include "tests/support/visible_surfaces.hpp"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace hs::tests {

using visibility::Polygon;
using visibility::WindowPolygon;
using visibility::WorldPolygon;

namespace {

template <typename Space>
Polygon<Space> triangle_of(std::uint32_t number, const std::array<glm::dvec3, 3>& corners) {
    Polygon<Space> polygon;
    polygon.triangle = number;
    for (int k = 0; k < 3; ++k) {
        glm::dvec3 weights{0.0};
        weights[k] = 1.0;
        polygon.corners.push_back({corners[static_cast<unsigned>(k)], weights});
    }
    return polygon;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

enum class Place {
    outside,
    inside,
    near_edge
};

Place place_of(const WindowPolygon& polygon, const glm::dvec2& point, double margin) {
    bool left = false;
    bool right = false;
    bool near = false;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const glm::dvec2 a{polygon.corners[i].position};
        const glm::dvec2 along{
            glm::dvec2{polygon.corners[(i + 1) % polygon.corners.size()].position} - a};
        const double length = glm::length(along);
        if (length == 0.0) {
            continue;
        }
        const double distance = cross(along, point - a) / length;
        const double t = glm::dot(along, point - a) / length;
        near = near || (std::fabs(distance) < margin && t > -margin && t < length + margin);
        left = left || distance > 0.0;
        right = right || distance < 0.0;
    }
    return near ? Place::near_edge : left == right ? Place::outside : Place::inside;
}

/// From sub-triangle areas: nothing the algorithms know.
double barycentric_depth(const WindowPolygon& triangle, const glm::dvec2& point) {
    const glm::dvec3& a = triangle.corners[0].position;
    const glm::dvec3& b = triangle.corners[1].position;
    const glm::dvec3& c = triangle.corners[2].position;
    const glm::dvec2 p{point};
    const double all = cross(glm::dvec2{b - a}, glm::dvec2{c - a});
    const double of_b = cross(p - glm::dvec2{a}, glm::dvec2{c - a}) / all;
    const double of_c = cross(glm::dvec2{b - a}, p - glm::dvec2{a}) / all;
    return a.z + of_b * (b.z - a.z) + of_c * (c.z - a.z);
}

} // namespace

WindowPolygon window_triangle(
    std::uint32_t triangle, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c
) {
    return triangle_of<visibility::WindowSpace>(triangle, {a, b, c});
}

WorldPolygon world_triangle(
    std::uint32_t triangle, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c
) {
    return triangle_of<math::WorldSpace>(triangle, {a, b, c});
}

WindowPolygon window_rectangle(
    std::uint32_t number, const glm::dvec2& low, const glm::dvec2& high, double depth
) {
    WindowPolygon polygon;
    polygon.triangle = 2 * number;
    polygon.triangle_count = 2;
    for (const glm::dvec2& corner :
         {low, glm::dvec2{high.x, low.y}, high, glm::dvec2{low.x, high.y}}) {
        polygon.corners.push_back({{corner, depth}, {}});
    }
    return polygon;
}

std::vector<WindowPolygon>
random_window_triangles(std::uint32_t count, float size, Random& random) {
    std::vector<WindowPolygon> triangles;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 middle{
            random.between(0.0F, 100.0F), random.between(0.0F, 100.0F), random.between(0.2F, 0.8F)};
        std::array<glm::dvec3, 3> corners{};
        for (glm::dvec3& corner : corners) {
            const glm::vec3 offset{
                random.between(-size, size),
                random.between(-size, size),
                random.between(-0.2F, 0.2F)};
            corner = glm::dvec3{middle + offset};
        }
        triangles.push_back(triangle_of<visibility::WindowSpace>(i, corners));
    }
    return triangles;
}

std::vector<WindowPolygon> six_polygons() {
    return {
        window_rectangle(0, {7, 3}, {12, 7}, 0.4),
        window_rectangle(1, {2, 2}, {8, 8}, 0.9),
        window_rectangle(2, {4, 5}, {10, 10}, 0.6),
        window_rectangle(3, {1, 6}, {5, 11}, 0.8),
        window_rectangle(4, {9, 6}, {14, 12}, 0.2),
        window_rectangle(5, {12, 13}, {15, 15}, 0.5)};
}

std::vector<WindowPolygon> ring_of_bars(std::uint32_t count) {
    constexpr double pi = 3.14159265358979323846;
    std::vector<WindowPolygon> bars;
    for (std::uint32_t i = 0; i < count; ++i) {
        // Far at its first end, near at its second, which lies over the next bar's first
        const auto at = [&](double turn, double radius, double depth) {
            const double angle = 2.0 * pi * (i + turn) / count;
            return glm::dvec3{
                50.0 + radius * std::cos(angle), 50.0 + radius * std::sin(angle), depth};
        };
        bars.push_back(
            window_triangle(i, at(-0.4, 40.0, 0.7), at(1.3, 38.0, 0.3), at(1.3, 42.0, 0.3))
        );
    }
    return bars;
}

std::optional<int> painted_at(
    std::span<const WindowPolygon> polygons,
    std::span<const std::int32_t> order,
    const glm::dvec2& point,
    double margin
) {
    int seen = -1;
    for (const std::int32_t i : order) {
        const WindowPolygon& polygon = polygons[static_cast<std::size_t>(i)];
        const Place place = place_of(polygon, point, margin);
        if (place == Place::near_edge) {
            return std::nullopt;
        }
        if (place == Place::inside) {
            seen = static_cast<int>(polygon.triangle);
        }
    }
    return seen;
}

std::optional<int> nearest_at(
    std::span<const WindowPolygon> triangles,
    const glm::dvec2& point,
    double margin,
    double depth_margin
) {
    int nearest = -1;
    double depth = std::numeric_limits<double>::infinity();
    double second = depth;
    for (const WindowPolygon& triangle : triangles) {
        const Place place = place_of(triangle, point, margin);
        if (place == Place::near_edge) {
            return std::nullopt;
        }
        if (place == Place::outside) {
            continue;
        }
        const double z = barycentric_depth(triangle, point);
        if (z < depth) {
            nearest = static_cast<int>(triangle.triangle);
            second = depth;
            depth = z;
        } else if (z < second) {
            second = z;
        }
    }
    return second - depth < depth_margin ? std::nullopt : std::optional{nearest};
}

std::optional<bool> back_to_front_at(
    std::span<const WindowPolygon> given,
    std::span<const WindowPolygon> polygons,
    std::span<const std::int32_t> order,
    const glm::dvec2& point,
    double margin,
    double depth_margin
) {
    double last = std::numeric_limits<double>::infinity();
    bool sorted = true;
    for (const std::int32_t i : order) {
        const WindowPolygon& polygon = polygons[static_cast<std::size_t>(i)];
        const Place place = place_of(polygon, point, margin);
        if (place == Place::near_edge) {
            return std::nullopt;
        }
        if (place == Place::inside) {
            const double depth = barycentric_depth(given[polygon.triangle], point);
            if (std::fabs(depth - last) < depth_margin) {
                return std::nullopt;
            }
            sorted = sorted && depth < last;
            last = depth;
        }
    }
    return sorted;
}

std::vector<WorldPolygon> random_world_triangles(std::uint32_t count, float size, Random& random) {
    const auto within = [&](float reach) {
        return glm::vec3{
            random.between(-reach, reach),
            random.between(-reach, reach),
            random.between(-reach, reach)};
    };
    std::vector<WorldPolygon> triangles;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 middle = within(1.0F);
        std::array<glm::dvec3, 3> corners{};
        for (glm::dvec3& corner : corners) {
            corner = glm::dvec3{middle + within(size)};
        }
        triangles.push_back(triangle_of<math::WorldSpace>(i, corners));
    }
    return triangles;
}

Ray random_ray(const glm::dvec4& eye, Random& random) {
    const glm::dvec3 target{
        random.between(-1.0F, 1.0F), random.between(-1.0F, 1.0F), random.between(-1.0F, 1.0F)};
    if (eye.w == 0.0) {
        return {target + 100.0 * glm::dvec3{eye}, -glm::dvec3{eye}};
    }
    const glm::dvec3 origin = glm::dvec3{eye} / eye.w;
    return {origin, glm::normalize(target - origin)};
}

namespace {

struct Meeting {
    bool unclear = false;
    bool met = false;
    double distance = 0.0;
};

Meeting meet(const WorldPolygon& polygon, const Ray& ray, double margin) {
    const std::size_t count = polygon.corners.size();
    glm::dvec3 normal{0.0};
    for (std::size_t i = 0; i < count; ++i) {
        normal += glm::cross(
            polygon.corners[i].position - polygon.corners[0].position,
            polygon.corners[(i + 1) % count].position - polygon.corners[0].position
        );
    }
    if (normal == glm::dvec3{0.0}) {
        return {};
    }
    normal = glm::normalize(normal);
    const double along = glm::dot(normal, ray.direction);
    if (along == 0.0) {
        return {.unclear = true};
    }
    const double t = glm::dot(normal, polygon.corners[0].position - ray.origin) / along;
    const glm::dvec3 p = ray.origin + t * ray.direction;

    // Distances from the edges in the plane, positive inside
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 a = polygon.corners[i].position;
        const glm::dvec3 edge = polygon.corners[(i + 1) % count].position - a;
        if (glm::length(edge) > 0.0) {
            const glm::dvec3 inward = glm::normalize(glm::cross(normal, edge));
            nearest = std::min(nearest, glm::dot(inward, p - a));
        }
    }
    // Near an edge, along the plane or at the eye itself rounding decides
    const bool grazing = std::fabs(along) < 0.01 || t < margin;
    return {
        .unclear = t > -margin && (std::fabs(nearest) < margin || (grazing && nearest > -margin)),
        .met = t > 0.0 && nearest > 0.0,
        .distance = t};
}

} // namespace

std::optional<int> first_met(
    std::span<const WorldPolygon> polygons,
    std::span<const std::int32_t> order,
    const Ray& ray,
    double margin
) {
    for (const std::int32_t i : order) {
        const WorldPolygon& polygon = polygons[static_cast<std::size_t>(i)];
        const Meeting meeting = meet(polygon, ray, margin);
        if (meeting.unclear) {
            return std::nullopt;
        }
        if (meeting.met) {
            return static_cast<int>(polygon.triangle);
        }
    }
    return -1;
}

std::optional<bool> front_to_back_along(
    std::span<const WorldPolygon> polygons,
    std::span<const std::int32_t> order,
    const Ray& ray,
    double margin
) {
    double last = 0.0;
    bool sorted = true;
    for (const std::int32_t i : order) {
        const Meeting meeting = meet(polygons[static_cast<std::size_t>(i)], ray, margin);
        if (meeting.unclear || (meeting.met && std::fabs(meeting.distance - last) < margin)) {
            return std::nullopt;
        }
        if (meeting.met) {
            sorted = sorted && meeting.distance > last;
            last = meeting.distance;
        }
    }
    return sorted;
}

std::optional<int>
nearest_met(std::span<const WorldPolygon> triangles, const Ray& ray, double margin) {
    int nearest = -1;
    double distance = std::numeric_limits<double>::infinity();
    double second = distance;
    for (const WorldPolygon& triangle : triangles) {
        const Meeting meeting = meet(triangle, ray, margin);
        if (meeting.unclear) {
            return std::nullopt;
        }
        if (meeting.met && meeting.distance < distance) {
            nearest = static_cast<int>(triangle.triangle);
            second = distance;
            distance = meeting.distance;
        } else if (meeting.met) {
            second = std::min(second, meeting.distance);
        }
    }
    return second - distance < margin ? std::nullopt : std::optional{nearest};
}

} // namespace hs::tests
