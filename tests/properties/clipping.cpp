// Clipping in clip space: what comes out is inside, and nothing else has changed.
#include "core/geometry/clip_polygon.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace hs;
using geometry::ClipPolygon;
using geometry::ClipVertex;
using geometry::ClipVolume;
using geometry::Outcode;

namespace {

/// A new vertex is in + t (out − in): three roundings per coordinate and the last bits of t, each
/// at most 2⁻²⁴ of the longest term. Eight of them, of the magnitudes that went in, suffice however
/// many planes clip, because a later plane only mixes what earlier ones made.
constexpr double relative_tolerance = 8.0 * 0x1p-24;

struct Silent {
    void clipped(geometry::ClipPlane, const ClipPolygon&, const ClipPolygon&) {}
};

ClipPolygon clipped(const ClipPolygon& polygon, const ClipVolume& volume) {
    unsigned crossed = 0;
    for (int i = 0; i < polygon.count; ++i) {
        crossed |= geometry::outcode(volume, polygon[i].position);
    }
    Silent silent;
    return geometry::clip_polygon(polygon, volume, static_cast<Outcode>(crossed), silent);
}

/// Coordinates of every size, w of either sign; varyings repeat the position.
ClipVertex random_vertex(float reach, tests::Random& random) {
    const auto coordinate = [&] { return random.between(-reach, reach); };
    const glm::vec4 p{coordinate(), coordinate(), coordinate(), random.between(-1.0F, 3.0F)};
    ClipVertex vertex;
    vertex.position = math::to_position<math::ClipSpace>(p);
    vertex.varyings.set(0, p);
    return vertex;
}

ClipPolygon triangle(const ClipVertex& a, const ClipVertex& b, const ClipVertex& c) {
    ClipPolygon polygon;
    polygon.add(a);
    polygon.add(b);
    polygon.add(c);
    return polygon;
}

ClipVolume random_volume(tests::Random& random) {
    scene::Settings settings;
    settings.depth_convention = static_cast<scene::DepthConvention>(random.below(3));
    const std::uint32_t user_planes = random.below(3);
    for (std::uint32_t k = 0; k < user_planes; ++k) {
        const auto coordinate = [&] { return random.between(-1.0F, 1.0F); };
        settings.clip_planes.emplace_back(coordinate(), coordinate(), coordinate(), coordinate());
    }
    return geometry::clip_volume(settings, glm::mat4{1.0F});
}

/// Calls `check(triangle, volume)`.
template <typename Check>
void for_many_triangles(int count, Check&& check) {
    tests::Random random(101);
    for (int i = 0; i < count; ++i) {
        constexpr std::array reaches{1.2F, 2.5F, 20.0F, 1000.0F};
        const float reach = reaches[random.below(reaches.size())];
        const ClipPolygon polygon = triangle(
            random_vertex(reach, random), random_vertex(reach, random), random_vertex(reach, random)
        );
        check(polygon, random_volume(random));
    }
}

glm::dvec4 position(const ClipPolygon& polygon, int i) {
    return glm::dvec4{math::to_vec4(polygon[i].position)};
}

double exact_distance(const math::HalfSpace& h, const glm::dvec4& p) {
    return glm::dot(glm::dvec4{h.a, h.b, h.c, h.d}, p);
}

/// The largest sum of absolute terms of a plane's distance, over a polygon's vertices.
double magnitude(const math::HalfSpace& h, const ClipPolygon& polygon) {
    double largest = 0.0;
    const glm::dvec4 plane = glm::abs(glm::dvec4{h.a, h.b, h.c, h.d});
    for (int i = 0; i < polygon.count; ++i) {
        largest = std::max(largest, glm::dot(plane, glm::abs(position(polygon, i))));
    }
    return largest;
}

double size_of(const ClipPolygon& polygon) {
    double largest = 0.0;
    for (int i = 0; i < polygon.count; ++i) {
        largest = std::max(largest, glm::length(position(polygon, i)));
    }
    return largest;
}

double distance_to_segment(const glm::dvec4& p, const glm::dvec4& a, const glm::dvec4& b) {
    const glm::dvec4 along = b - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * along);
}

double distance_to_outline(const glm::dvec4& p, const ClipPolygon& polygon) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < polygon.count; ++i) {
        const int next = (i + 1) % polygon.count;
        nearest = std::min(
            nearest, distance_to_segment(p, position(polygon, i), position(polygon, next))
        );
    }
    return nearest;
}

} // namespace

TEST_CASE("a clipped polygon lies inside every plane", "[property][clip]") {
    double worst = 0.0; // in tolerances
    int kept = 0;
    for_many_triangles(50'000, [&](const ClipPolygon& polygon, const ClipVolume& volume) {
        const ClipPolygon result = clipped(polygon, volume);
        kept += result.count > 0 ? 1 : 0;
        for (int k = 0; k < volume.count; ++k) {
            const math::HalfSpace& plane = volume.planes[static_cast<unsigned>(k)];
            const double tolerance = relative_tolerance * magnitude(plane, polygon);
            for (int i = 0; i < result.count; ++i) {
                worst = std::max(worst, -exact_distance(plane, position(result, i)) / tolerance);
            }
        }
    });
    CHECK(kept > 10'000);
    CHECK(worst <= 1.0);
}

TEST_CASE("a polygon clipped by k planes has at most 3 + k vertices", "[property][clip]") {
    int wrong = 0;
    for_many_triangles(50'000, [&](const ClipPolygon& polygon, const ClipVolume& volume) {
        const int count = clipped(polygon, volume).count;
        wrong += count == 0 || (count >= 3 && count <= 3 + volume.count) ? 0 : 1;
    });
    CHECK(wrong == 0);
}

TEST_CASE("clipping what is clipped already gives the same polygon", "[property][clip]") {
    // A rounded vertex may lie outside by its last bits, and be clipped again. Then an edge that
    // runs along the plane may get a new vertex anywhere on it; so vertices are compared with the
    // other polygon's outline, both ways.
    double worst = 0.0;
    for_many_triangles(50'000, [&](const ClipPolygon& polygon, const ClipVolume& volume) {
        const ClipPolygon once = clipped(polygon, volume);
        const ClipPolygon twice = clipped(once, volume);
        const double tolerance = volume.count * relative_tolerance * size_of(polygon); // adds up
        for (int i = 0; i < twice.count; ++i) {
            worst = std::max(worst, distance_to_outline(position(twice, i), once) / tolerance);
        }
        for (int i = 0; twice.count > 0 && i < once.count; ++i) {
            worst = std::max(worst, distance_to_outline(position(once, i), twice) / tolerance);
        }
    });
    CHECK(worst <= 1.0);
}

TEST_CASE("a polygon inside every plane passes unchanged", "[property][clip]") {
    int inside = 0;
    int changed = 0;
    for_many_triangles(50'000, [&](const ClipPolygon& polygon, const ClipVolume& volume) {
        const ClipPolygon once = clipped(polygon, volume);
        bool all = once.count > 0;
        for (int i = 0; i < once.count; ++i) {
            all = all && geometry::outcode(volume, once[i].position) == 0;
        }
        if (!all) {
            return;
        }
        ++inside;
        const ClipPolygon twice = clipped(once, volume);
        changed += twice.count == once.count ? 0 : 1;
        for (int i = 0; i < once.count && i < twice.count; ++i) {
            changed += twice[i].position == once[i].position ? 0 : 1;
        }
    });
    CHECK(inside > 1000);
    CHECK(changed == 0);
}

TEST_CASE("varyings are cut where positions are", "[property][clip]") {
    int wrong = 0;
    for_many_triangles(50'000, [&](const ClipPolygon& polygon, const ClipVolume& volume) {
        const ClipPolygon result = clipped(polygon, volume);
        for (int i = 0; i < result.count; ++i) {
            const glm::vec4 p = math::to_vec4(result[i].position);
            wrong += result[i].varyings.color() == p ? 0 : 1; // they repeated the position
        }
    });
    CHECK(wrong == 0);
}

TEST_CASE("new vertices lie between the two they were made from", "[property][clip]") {
    double worst = 0.0;
    for_many_triangles(50'000, [&](const ClipPolygon& polygon, const ClipVolume& volume) {
        for (int k = 0; k < volume.count; ++k) {
            const ClipPolygon result =
                geometry::clip_against(polygon, volume.planes[static_cast<unsigned>(k)]);
            for (int i = 0; i < result.count; ++i) {
                const double distance = distance_to_outline(position(result, i), polygon);
                worst = std::max(worst, distance / (relative_tolerance * size_of(polygon)));
            }
        }
    });
    CHECK(worst <= 1.0);
}

TEST_CASE("two triangles cut their shared edge at the very same vertices", "[property][clip]") {
    tests::Random random(102);
    int cuts = 0;
    int missing = 0;
    for (int i = 0; i < 50'000; ++i) {
        const ClipVertex a = random_vertex(2.5F, random);
        const ClipVertex b = random_vertex(2.5F, random);
        const ClipVolume volume = random_volume(random);
        const auto& plane = volume.planes[random.below(static_cast<std::uint32_t>(volume.count))];
        // The edge runs from a to b in one triangle and from b to a in the other
        const ClipPolygon one =
            geometry::clip_against(triangle(a, b, random_vertex(2.5F, random)), plane);
        const ClipPolygon other =
            geometry::clip_against(triangle(b, a, random_vertex(2.5F, random)), plane);
        const float d_a = math::signed_distance(plane, math::to_vec4(a.position));
        const float d_b = math::signed_distance(plane, math::to_vec4(b.position));
        if (math::inside(d_a) == math::inside(d_b)) {
            continue;
        }
        const ClipVertex cut = math::inside(d_a) ? geometry::intersect_edge(a, d_a, b, d_b)
                                                 : geometry::intersect_edge(b, d_b, a, d_a);
        ++cuts;
        for (const ClipPolygon* polygon : {&one, &other}) {
            bool found = false;
            for (int k = 0; k < polygon->count; ++k) {
                found = found || (*polygon)[k].position == cut.position;
            }
            missing += found ? 0 : 1;
        }
    }
    CHECK(cuts > 10'000);
    CHECK(missing == 0);
}

namespace {

/// Of a polygon with w = 1 everywhere.
double area(const ClipPolygon& polygon) {
    glm::dvec3 doubled{0.0};
    for (int i = 1; i + 1 < polygon.count; ++i) {
        const glm::dvec3 origin{position(polygon, 0)};
        doubled += glm::cross(
            glm::dvec3{position(polygon, i)} - origin, glm::dvec3{position(polygon, i + 1)} - origin
        );
    }
    return 0.5 * glm::length(doubled);
}

math::HalfSpace opposite(const math::HalfSpace& h) {
    return {-h.a, -h.b, -h.c, -h.d};
}

} // namespace

TEST_CASE("the two sides of a plane share a triangle's area", "[property][clip]") {
    double worst = 0.0;
    for_many_triangles(50'000, [&](ClipPolygon polygon, const ClipVolume& volume) {
        for (ClipVertex& vertex : polygon.vertices) {
            vertex.position.w = 1.0F;
        }
        const math::HalfSpace& plane = volume.planes[static_cast<unsigned>(volume.count - 1)];
        const double inside = area(geometry::clip_against(polygon, plane));
        const double outside = area(geometry::clip_against(polygon, opposite(plane)));
        const double size = size_of(polygon);
        const double lost = std::fabs(area(polygon) - inside - outside);
        worst = std::max(worst, lost / (relative_tolerance * size * size));
    });
    CHECK(worst <= 1.0);
}
