// What is drawn when: every triangle, or the parts that an ordering algorithm has cut it into.
#pragma once

#include "core/pipeline/frame.hpp"
#include "core/visibility/polygon.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace hs::pipeline {

struct Sweep;

/// One triangle to draw, or a part of one; or a row of the image that shows what is nearest of all
/// of them.
struct Draw {
    std::uint32_t object = 0;
    std::uint32_t triangle = 0; ///< of the object
    std::int32_t part = -1;     ///< index into DrawOrder::parts; −1: the whole triangle
    std::int32_t row = -1;      ///< of the image; −1: a triangle, see above
    bool stuck = false;         ///< no order exists for it: it is passed over
};

/// A triangle within a triangle.
struct TrianglePart {
    std::array<glm::dvec3, 3> weights{}; ///< each corner's, of the triangle's vertices in clip
                                         ///< coordinates; they sum to one
    int first_piece = 0;                 ///< pieces of one triangle are numbered on over its parts
};

/// Which triangle a polygon that an algorithm speaks of belongs to.
struct OrderedPolygon {
    std::uint32_t triangle = 0; ///< over the whole frame, in file order; of a face the first
    std::uint32_t triangle_count = 1;
    std::uint32_t part = 0;
    bool split = false;
};

template <typename Space>
[[nodiscard]] OrderedPolygon ordered_polygon(const visibility::Polygon<Space>& polygon) {
    return {polygon.triangle, polygon.triangle_count, polygon.part, polygon.split};
}

struct DrawOrder {
    std::vector<Draw> draws;              ///< every triangle at least once
    std::vector<TrianglePart> parts;      ///< empty unless something was split
    std::vector<OrderedPolygon> polygons; ///< by the numbers that events use
    std::shared_ptr<const Sweep> sweep;   ///< where rows are drawn, the triangles they are made of
};

/// All triangles one after the other, object by object.
DrawOrder file_order(const Frame& frame);

/// All triangles, as far as each goes by itself, then the rows of the image. Precondition: the
/// vertex stage has run.
DrawOrder rows_after_triangles(const Frame& frame);

/// An algorithm's answer, in indices of polygons.
struct OrderAnswer {
    const std::vector<std::int32_t>& order;
    const std::vector<std::int32_t>& stuck; ///< can never be drawn
    const std::vector<Draw>& unseen;        ///< triangles it was not asked about
};

/// The draws that an answer means. What is stuck is passed over; the triangles of `unseen` come
/// last: they go through their stages like all others and change nothing.
template <typename Space>
DrawOrder draw_order(
    const Frame& frame,
    const std::vector<visibility::Polygon<Space>>& polygons,
    const OrderAnswer& answer
);

} // namespace hs::pipeline
