#include "core/pipeline/draw_order.hpp"

#include "core/pipeline/draw.hpp"
#include "core/pipeline/sweep.hpp"

#include <algorithm>
#include <map>

namespace hs::pipeline {
namespace {

/// From numbers over the whole frame to objects and their own.
class TriangleNumbers {
public:
    explicit TriangleNumbers(const Frame& frame) {
        std::uint32_t first = 0;
        for (const DrawCall& call : frame.calls()) {
            first_.push_back(first);
            first += call.primitive_count();
        }
    }

    [[nodiscard]] Draw whole(std::uint32_t triangle) const {
        const auto after = std::upper_bound(first_.begin(), first_.end(), triangle);
        return {
            .object = static_cast<std::uint32_t>(after - first_.begin()) - 1,
            .triangle = triangle - *(after - 1)};
    }

private:
    std::vector<std::uint32_t> first_;
};

/// Pieces that clipping may leave of a part. One that rounding put outside still has a number.
int piece_count(const DrawCall& call, const ShadedPart& part) {
    if (!call.settings.clip_enabled) {
        return 1;
    }
    NullTrace nothing;
    const geometry::ClipPolygon kept =
        geometry::clip_polygon(part.polygon, call.volume, part.crossed(), nothing);
    return std::max(1, kept.count - 2);
}

/// Cuts what an algorithm split into triangles that are drawn one by one.
class PartList {
public:
    explicit PartList(const Frame& frame) : frame_(frame) {}

    template <typename Space>
    void add(DrawOrder& order, Draw draw, const visibility::Polygon<Space>& polygon) {
        const DrawCall& call = frame_.calls()[draw.object];
        int& next_piece = next_piece_[polygon.triangle];
        for (std::size_t k = 1; k + 1 < polygon.corners.size(); ++k) {
            TrianglePart part{.first_piece = next_piece};
            const std::array corners{std::size_t{0}, k, k + 1};
            for (unsigned corner = 0; corner < 3; ++corner) {
                const glm::dvec3& weights = polygon.corners[corners[corner]].weights;
                part.weights[corner] = weights / (weights.x + weights.y + weights.z);
            }
            next_piece += piece_count(call, assemble(call, call.triangles()[draw.triangle], part));
            draw.part = static_cast<std::int32_t>(order.parts.size());
            order.parts.push_back(part);
            order.draws.push_back(draw);
        }
    }

private:
    const Frame& frame_;
    std::map<std::uint32_t, int> next_piece_; ///< by triangle over the whole frame
};

} // namespace

DrawOrder file_order(const Frame& frame) {
    DrawOrder order;
    for (const DrawCall& call : frame.calls()) {
        for (std::uint32_t i = 0; i < call.primitive_count(); ++i) {
            order.draws.push_back({call.object, i});
        }
    }
    return order;
}

DrawOrder rows_after_triangles(const Frame& frame) {
    DrawOrder order = file_order(frame);
    const PixelRect region = swept_region(frame);
    for (int row = region.y0; row < region.y1; ++row) {
        order.draws.push_back({.row = row});
    }
    order.sweep = make_sweep(frame);
    return order;
}

template <typename Space>
DrawOrder draw_order(
    const Frame& frame,
    const std::vector<visibility::Polygon<Space>>& polygons,
    const OrderAnswer& answer
) {
    DrawOrder result;
    for (const visibility::Polygon<Space>& polygon : polygons) {
        result.polygons.push_back(ordered_polygon(polygon));
    }
    const TriangleNumbers numbers(frame);
    PartList parts(frame);
    const auto add_triangles = [&](const visibility::Polygon<Space>& polygon, bool stuck) {
        for (std::uint32_t i = 0; i < polygon.triangle_count; ++i) {
            result.draws.push_back(numbers.whole(polygon.triangle + i));
            result.draws.back().stuck = stuck;
        }
    };
    for (const std::int32_t index : answer.order) {
        const visibility::Polygon<Space>& polygon = polygons[static_cast<std::size_t>(index)];
        if (polygon.split) {
            parts.add(result, numbers.whole(polygon.triangle), polygon);
        } else {
            add_triangles(polygon, false);
        }
    }
    for (const std::int32_t index : answer.stuck) {
        add_triangles(polygons[static_cast<std::size_t>(index)], true);
    }
    result.draws.insert(result.draws.end(), answer.unseen.begin(), answer.unseen.end());
    return result;
}

template DrawOrder
draw_order(const Frame&, const std::vector<visibility::WindowPolygon>&, const OrderAnswer&);
template DrawOrder
draw_order(const Frame&, const std::vector<visibility::WorldPolygon>&, const OrderAnswer&);

} // namespace hs::pipeline
