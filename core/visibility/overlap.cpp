#include "core/visibility/overlap.hpp"

#include <algorithm>
#include <cmath>

namespace hs::visibility {

namespace {

/// The line through an edge, positive on the polygon's side.
struct EdgeLine {
    glm::dvec2 normal{0.0};
    glm::dvec2 origin{0.0};
    double tolerance = 0.0;

    /// Differences of float coordinates and their products are exact or nearly so in double.
    [[nodiscard]] double distance(const glm::dvec2& p) const {
        return glm::dot(normal, p - origin);
    }
    [[nodiscard]] bool outside(const WindowPolygon& polygon) const {
        return std::ranges::none_of(polygon.corners, [&](const Corner<WindowSpace>& corner) {
            return distance(glm::dvec2{corner.position}) > tolerance;
        });
    }
};

/// Lines of all edges that have a length.
std::vector<EdgeLine> edge_lines(const WindowPolygon& polygon, const glm::dvec3& reach) {
    const double winding = newell_sum(polygon).z < 0.0 ? -1.0 : 1.0;
    std::vector<EdgeLine> lines;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const glm::dvec2 a{polygon.corners[i].position};
        const glm::dvec2 b{polygon.corners[(i + 1) % polygon.corners.size()].position};
        if (a != b) {
            EdgeLine line{winding * glm::dvec2{a.y - b.y, b.x - a.x}, a};
            line.tolerance =
                relative_tolerance * glm::dot(glm::abs(line.normal), glm::dvec2{reach});
            lines.push_back(line);
        }
    }
    return lines;
}

/// Is `b` outside an edge of `a`, or has `a` no area to overlap with?
bool separated_by_edge(
    const std::vector<EdgeLine>& lines, const WindowPolygon& a, const WindowPolygon& b
) {
    return lines.empty() || std::ranges::any_of(lines, [&](const EdgeLine& line) {
               return line.outside(b) || line.outside(a);
           });
}

std::vector<glm::dvec2> clip(const std::vector<glm::dvec2>& region, const EdgeLine& line) {
    std::vector<glm::dvec2> kept;
    for (std::size_t i = 0; i < region.size(); ++i) {
        const glm::dvec2& current = region[i];
        const glm::dvec2& next = region[(i + 1) % region.size()];
        const double d_current = line.distance(current);
        const double d_next = line.distance(next);
        if (d_current >= 0.0) {
            kept.push_back(current);
        }
        if ((d_current > 0.0 && d_next < 0.0) || (d_current < 0.0 && d_next > 0.0)) {
            kept.push_back(current + d_current / (d_current - d_next) * (next - current));
        }
    }
    return kept;
}

} // namespace

bool projections_overlap(const WindowPolygon& a, const WindowPolygon& b, const glm::dvec3& reach) {
    return !separated_by_edge(edge_lines(a, reach), a, b) &&
           !separated_by_edge(edge_lines(b, reach), b, a);
}

std::vector<glm::dvec2>
common_region(const WindowPolygon& a, const WindowPolygon& b, const glm::dvec3& reach) {
    std::vector<glm::dvec2> region;
    if (!projections_overlap(a, b, reach)) {
        return region;
    }
    for (const Corner<WindowSpace>& corner : a.corners) {
        region.emplace_back(corner.position);
    }
    for (const EdgeLine& line : edge_lines(b, reach)) {
        region = clip(region, line);
    }
    return region;
}

} // namespace hs::visibility
