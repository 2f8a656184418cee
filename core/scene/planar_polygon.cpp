#include "core/scene/planar_polygon.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hs::scene {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Twice the signed area: positive when a, b, c run counter-clockwise.
double signed_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return cross(b - a, c - a);
}

glm::dvec3 newell_normal(std::span<const glm::dvec3> points) {
    glm::dvec3 normal{0.0};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3& p = points[i];
        const glm::dvec3& q = points[(i + 1) % points.size()];
        normal.x += (p.y - q.y) * (p.z + q.z);
        normal.y += (p.z - q.z) * (p.x + q.x);
        normal.z += (p.x - q.x) * (p.y + q.y);
    }
    return normal;
}

/// The two coordinates that remain, in the order that keeps the polygon counter-clockwise.
glm::dvec2 drop_coordinate(const glm::dvec3& p, int axis, bool positive) {
    const glm::dvec2 kept = axis == 0   ? glm::dvec2{p.y, p.z}
                            : axis == 1 ? glm::dvec2{p.z, p.x}
                                        : glm::dvec2{p.x, p.y};
    return positive ? kept : glm::dvec2{kept.y, kept.x};
}

int largest_coordinate(const glm::dvec3& v) {
    const glm::dvec3 size = glm::abs(v);
    if (size.x >= size.y && size.x >= size.z) {
        return 0;
    }
    return size.y >= size.z ? 1 : 2;
}

bool sees_all_others(const PlanarPolygon& polygon, std::size_t corner) {
    const std::size_t count = polygon.size();
    const auto direction = [&](std::size_t i) {
        return polygon[(corner + i) % count] - polygon[corner];
    };
    const glm::dvec2 first = direction(1);
    for (std::size_t i = 1; i + 1 < count; ++i) {
        const glm::dvec2 a = direction(i);
        const glm::dvec2 b = direction(i + 1);
        // Turning past the first direction again means that the polygon winds around the corner.
        const bool winds = cross(first, a) < 0.0 && cross(first, b) >= 0.0;
        if (!(cross(a, b) > 0.0) || winds) {
            return false;
        }
    }
    return true;
}

/// Keeps the part of a convex region to the left of the line from a to b (Sutherland and Hodgman
/// 1974).
PlanarPolygon keep_left(const PlanarPolygon& region, const glm::dvec2& a, const glm::dvec2& b) {
    PlanarPolygon kept;
    for (std::size_t i = 0; i < region.size(); ++i) {
        const glm::dvec2& p = region[i];
        const glm::dvec2& q = region[(i + 1) % region.size()];
        const double distance_p = signed_area(a, b, p);
        const double distance_q = signed_area(a, b, q);
        if (distance_p >= 0.0) {
            kept.push_back(p);
        }
        if ((distance_p >= 0.0) != (distance_q >= 0.0)) {
            kept.push_back(p + (q - p) * (distance_p / (distance_p - distance_q)));
        }
    }
    return kept;
}

double area(const PlanarPolygon& polygon) {
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        sum += signed_area(polygon[0], polygon[i], polygon[i + 1]);
    }
    return 0.5 * sum;
}

PlanarPolygon bounding_box(const PlanarPolygon& polygon) {
    glm::dvec2 low = polygon[0];
    glm::dvec2 high = polygon[0];
    for (const glm::dvec2& p : polygon) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return {low, {high.x, low.y}, high, {low.x, high.y}};
}

/// The corners that are left while ears are cut, linked in a ring.
class EarClipper {
public:
    explicit EarClipper(const PlanarPolygon& polygon)
        : polygon_(polygon),
          previous_(polygon.size()),
          next_(polygon.size()),
          is_ear_(polygon.size()),
          is_left_(polygon.size(), true),
          left_(polygon.size()) {
        for (std::size_t i = 0; i < left_; ++i) {
            next_[i] = (i + 1) % left_;
            previous_[next_[i]] = i;
        }
        for (std::size_t i = 0; i < left_; ++i) {
            is_ear_[i] = test_ear(i);
        }
    }

    std::vector<CornerTriangle> run() {
        std::vector<CornerTriangle> triangles;
        while (left_ > 3) {
            const auto ear = std::ranges::find(is_ear_, true);
            if (ear == is_ear_.end()) {
                break; // the polygon crosses or touches itself
            }
            triangles.push_back(cut(static_cast<std::size_t>(ear - is_ear_.begin())));
        }
        fan_the_rest(triangles);
        return triangles;
    }

private:
    [[nodiscard]] double corner_area(std::size_t i) const {
        return signed_area(polygon_[previous_[i]], polygon_[i], polygon_[next_[i]]);
    }

    /// An ear turns left, and no corner that does not turn left lies in its triangle or on the
    /// border.
    [[nodiscard]] bool test_ear(std::size_t i) const {
        if (!(corner_area(i) > 0.0)) {
            return false;
        }
        const glm::dvec2& a = polygon_[previous_[i]];
        const glm::dvec2& b = polygon_[i];
        const glm::dvec2& c = polygon_[next_[i]];
        for (std::size_t k = next_[next_[i]]; k != previous_[i]; k = next_[k]) {
            const glm::dvec2& p = polygon_[k];
            const bool same_place = p == a || p == b || p == c;
            if (!same_place && !(corner_area(k) > 0.0) && signed_area(a, b, p) >= 0.0 &&
                signed_area(b, c, p) >= 0.0 && signed_area(c, a, p) >= 0.0) {
                return false;
            }
        }
        return true;
    }

    /// Only the two neighbors can change between ear and not ear.
    CornerTriangle cut(std::size_t ear) {
        const std::size_t before = previous_[ear];
        const std::size_t after = next_[ear];
        next_[before] = after;
        previous_[after] = before;
        is_ear_[ear] = false;
        is_left_[ear] = false;
        --left_;
        is_ear_[before] = test_ear(before);
        is_ear_[after] = test_ear(after);
        return {before, ear, after};
    }

    void fan_the_rest(std::vector<CornerTriangle>& triangles) const {
        const auto first =
            static_cast<std::size_t>(std::ranges::find(is_left_, true) - is_left_.begin());
        for (std::size_t i = next_[first]; next_[i] != first; i = next_[i]) {
            triangles.push_back({first, i, next_[i]});
        }
    }

    const PlanarPolygon& polygon_;
    std::vector<std::size_t> previous_;
    std::vector<std::size_t> next_;
    std::vector<bool> is_ear_;
    std::vector<bool> is_left_;
    std::size_t left_;
};

} // namespace

std::optional<PlanarPolygon> lay_flat(std::span<const glm::vec4> corners) {
    std::vector<glm::dvec3> points;
    points.reserve(corners.size());
    for (const glm::vec4& corner : corners) {
        if (!(corner.w > 0.0F)) {
            return std::nullopt;
        }
        const glm::dvec4 p{corner};
        // Relative to the first corner: products of small differences keep their digits.
        const glm::dvec3 point = glm::dvec3{p} / p.w;
        points.push_back(points.empty() ? point : point - points[0]);
    }
    points[0] = glm::dvec3{0.0};
    const glm::dvec3 normal = newell_normal(points);
    const int axis = largest_coordinate(normal);
    if (normal[axis] == 0.0) {
        return std::nullopt;
    }
    PlanarPolygon polygon;
    polygon.reserve(points.size());
    for (const glm::dvec3& point : points) {
        polygon.push_back(drop_coordinate(point, axis, normal[axis] > 0.0));
    }
    return polygon;
}

std::optional<std::size_t> find_fan_corner(const PlanarPolygon& polygon) {
    for (std::size_t corner = 0; corner < polygon.size(); ++corner) {
        if (sees_all_others(polygon, corner)) {
            return corner;
        }
    }
    return std::nullopt;
}

std::optional<glm::dvec2> find_kernel_point(const PlanarPolygon& polygon) {
    constexpr double smallest_part = 1e-6; // of the polygon's area: a thinner kernel makes slivers
    PlanarPolygon kernel = bounding_box(polygon);
    for (std::size_t i = 0; i < polygon.size() && !kernel.empty(); ++i) {
        kernel = keep_left(kernel, polygon[i], polygon[(i + 1) % polygon.size()]);
    }
    if (kernel.size() < 3 || area(kernel) <= smallest_part * area(polygon)) {
        return std::nullopt;
    }
    glm::dvec2 sum{0.0};
    for (const glm::dvec2& p : kernel) {
        sum += p;
    }
    const glm::dvec2 point = sum / static_cast<double>(kernel.size());
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        if (!(signed_area(polygon[i], polygon[(i + 1) % polygon.size()], point) > 0.0)) {
            return std::nullopt;
        }
    }
    return point;
}

std::vector<double> mean_value_weights(const PlanarPolygon& polygon, const glm::dvec2& inside) {
    const std::size_t count = polygon.size();
    /// tan(α/2) of the angle under which edge i, i + 1 is seen.
    std::vector<double> half_tangents(count);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2 a = polygon[i] - inside;
        const glm::dvec2 b = polygon[(i + 1) % count] - inside;
        half_tangents[i] = std::tan(0.5 * std::atan2(cross(a, b), glm::dot(a, b)));
    }
    std::vector<double> weights(count);
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double tangents = half_tangents[(i + count - 1) % count] + half_tangents[i];
        weights[i] = tangents / glm::length(polygon[i] - inside);
        sum += weights[i];
    }
    for (double& weight : weights) {
        weight /= sum;
    }
    return weights;
}

std::vector<CornerTriangle> clip_ears(const PlanarPolygon& polygon) {
    return EarClipper{polygon}.run();
}

} // namespace hs::scene
