// Any triangle against any view volume: what is left lies inside, what was inside stays, what needs
// no clipping is not touched, and the winding does not matter.
#include "core/geometry/clip_polygon.hpp"
#include "tests/fuzz/bytes.hpp"
#include "tests/fuzz/target.hpp"

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

using namespace hs;
using geometry::ClipPolygon;
using geometry::ClipVolume;

namespace {

struct NullTrace {
    void clipped(geometry::ClipPlane, const ClipPolygon&, const ClipPolygon&) {}
};

geometry::Outcode any_outside(const ClipPolygon& polygon, const ClipVolume& volume) {
    unsigned any = 0;
    for (int i = 0; i < polygon.count; ++i) {
        any |= geometry::outcode(volume, polygon[i].position);
    }
    return static_cast<geometry::Outcode>(any);
}

ClipPolygon clipped(const ClipPolygon& polygon, const ClipVolume& volume) {
    NullTrace nothing;
    return geometry::clip_polygon(polygon, volume, any_outside(polygon, volume), nothing);
}

bool has_vertex(const ClipPolygon& polygon, const geometry::ClipVertex& vertex) {
    for (int i = 0; i < polygon.count; ++i) {
        const bool same =
            polygon[i].position == vertex.position && polygon[i].varyings == vertex.varyings;
        if (same) {
            return true;
        }
    }
    return false;
}

bool same_vertices(const ClipPolygon& a, const ClipPolygon& b) {
    bool same = a.count == b.count;
    for (int i = 0; same && i < a.count; ++i) {
        same = has_vertex(b, a[i]);
    }
    return same;
}

/// The largest number in a polygon's positions: rounding is relative to it.
float magnitude(const ClipPolygon& polygon) {
    float largest = 0.0F;
    for (int i = 0; i < polygon.count; ++i) {
        const math::ClipPosition& p = polygon[i].position;
        largest =
            std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z), std::fabs(p.w)});
    }
    return largest;
}

/// A vertex is made with one rounding per plane it met, and each distance with a few more.
void check_inside(const ClipPolygon& polygon, const ClipVolume& volume, float scale) {
    constexpr float roundings = 64.0F * 0x1p-24F;
    for (int k = 0; k < volume.count; ++k) {
        const math::HalfSpace& plane = volume.planes[static_cast<unsigned>(k)];
        const float size =
            std::fabs(plane.a) + std::fabs(plane.b) + std::fabs(plane.c) + std::fabs(plane.d);
        for (int i = 0; i < polygon.count; ++i) {
            const float distance = math::signed_distance(plane, math::to_vec4(polygon[i].position));
            HS_CHECK(distance >= -roundings * size * scale, "what is left lies inside");
        }
    }
}

ClipVolume take_volume(fuzz::Bytes& bytes) {
    scene::Settings settings;
    const auto choice = bytes.take<std::uint8_t>();
    settings.depth_convention = static_cast<scene::DepthConvention>(choice % 3);
    const int user_planes = choice / 3 % 3;
    const auto coefficient = [&] { return static_cast<float>(bytes.take<std::int8_t>()) / 16.0F; };
    for (int i = 0; i < user_planes; ++i) {
        const float a = coefficient();
        const float b = coefficient();
        const float c = coefficient();
        settings.clip_planes.emplace_back(a, b, c, coefficient());
    }
    return geometry::clip_volume(settings, glm::mat4{1.0F});
}

/// Two bytes per coordinate: a few powers of ten around 1, with many equal values.
float take_coordinate(fuzz::Bytes& bytes) {
    const auto mantissa = static_cast<float>(bytes.take<std::int8_t>()) / 16.0F;
    return std::ldexp(mantissa, bytes.take<std::int8_t>() % 12);
}

ClipPolygon take_triangle(fuzz::Bytes& bytes, bool wild) {
    ClipPolygon triangle;
    for (int i = 0; i < 3; ++i) {
        geometry::ClipVertex vertex;
        math::ClipPosition& p = vertex.position;
        for (float* coordinate : {&p.x, &p.y, &p.z, &p.w}) {
            *coordinate = wild ? bytes.take<float>() : take_coordinate(bytes);
        }
        vertex.varyings[0] = static_cast<float>(i);
        triangle.add(vertex);
    }
    return triangle;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Bytes bytes(data, size);
    const ClipVolume volume = take_volume(bytes);
    const bool wild = bytes.take<std::uint8_t>() % 8 == 0;
    const ClipPolygon triangle = take_triangle(bytes, wild);
    const ClipPolygon polygon = clipped(triangle, volume);
    HS_CHECK(polygon.count <= 3 + volume.count, "each plane adds at most one vertex");
    if (wild) {
        return 0; // infinities, NaN and overflows: nothing more is promised than to survive them
    }

    check_inside(polygon, volume, magnitude(triangle));
    for (int i = 0; i < 3; ++i) {
        const bool stays = geometry::outcode(volume, triangle[i].position) == 0;
        HS_CHECK(!stays || has_vertex(polygon, triangle[i]), "what was inside stays, bit by bit");
    }
    if (any_outside(polygon, volume) == 0) {
        HS_CHECK(
            same_vertices(clipped(polygon, volume), polygon), "clipping twice is clipping once"
        );
    }
    ClipPolygon reversed = triangle;
    std::swap(reversed.vertices[0], reversed.vertices[2]);
    HS_CHECK(
        same_vertices(clipped(reversed, volume), polygon), "an edge is cut alike from both sides"
    );
    return 0;
}
