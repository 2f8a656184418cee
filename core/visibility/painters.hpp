// Painter's algorithm: polygons sorted by one depth each, the farthest painted first.
//
// Sutherland, Sproull and Schumacker, A Characterization of Ten Hidden-Surface Algorithms, 1974,
// call it list priority without splitting. One number cannot say how two polygons lie, so that the
// picture is wrong wherever a polygon with a nearer key reaches behind another one; polygons that
// cross or cover each other in a ring have no right order at all.
//
// The sort is a straight two-way merge from the bottom up (Knuth, The Art of Computer Programming,
// volume 3, 5.2.4): at most n ⌈log₂ n⌉ comparisons, and stable, so that equal keys stay in file
// order.
#pragma once

#include "core/base/check.hpp"
#include "core/scene/settings.hpp"
#include "core/visibility/order_trace.hpp"
#include "core/visibility/polygon.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace hs::visibility {

/// The list being sorted. Events: `iteration` (pass `place` begins; runs of `value` polygons are
/// sorted), `compare` (heads of two runs: is `polygon`, of the later run, farther than `other`?
/// The answer decides who goes to `place`), `move`, `emit`.
struct PaintersSort {
    std::vector<WindowPolygon> polygons;
    std::vector<double> keys;        ///< by polygon
    std::vector<std::int32_t> list;  ///< sorted in runs of `run` polygons, farthest first
    std::vector<std::int32_t> moved; ///< into the next pass, so far
    std::size_t run = 1;             ///< polygons
    std::vector<std::int32_t> order; ///< drawn so far

    [[nodiscard]] double key(std::int32_t polygon) const {
        return keys[static_cast<std::size_t>(polygon)];
    }
};

/// The one depth that stands for a polygon; the centroid's is the average of the corners'.
[[nodiscard]] inline double painters_key(const WindowPolygon& polygon, scene::PaintersKey key) {
    double farthest = polygon.corners.front().position.z;
    double nearest = farthest;
    double sum = 0.0;
    for (const Corner<WindowSpace>& corner : polygon.corners) {
        farthest = std::max(farthest, corner.position.z);
        nearest = std::min(nearest, corner.position.z);
        sum += corner.position.z;
    }
    switch (key) {
    case scene::PaintersKey::farthest: return farthest;
    case scene::PaintersKey::nearest: return nearest;
    case scene::PaintersKey::centroid: return sum / static_cast<double>(polygon.corners.size());
    }
    HS_CHECK(false, "every key is handled");
    return farthest;
}

namespace painters_steps {

using Kind = OrderEventKind;

template <OrderSink<PaintersSort> Sink>
[[nodiscard]] bool
is_farther(const PaintersSort& sort, std::int32_t polygon, std::int32_t other, Sink& sink) {
    const bool farther = sort.key(polygon) > sort.key(other);
    sink.order_step(
        {.kind = Kind::compare,
         .verdict = farther,
         .polygon = polygon,
         .other = other,
         .place = static_cast<std::int32_t>(sort.moved.size()),
         .value = sort.key(polygon),
         .other_value = sort.key(other)},
        sort
    );
    return farther;
}

template <OrderSink<PaintersSort> Sink>
void move(PaintersSort& sort, std::int32_t polygon, Sink& sink) {
    const auto place = static_cast<std::int32_t>(sort.moved.size());
    sort.moved.push_back(polygon);
    sink.order_step(
        {.kind = Kind::move, .polygon = polygon, .place = place, .value = sort.key(polygon)}, sort
    );
}

/// The runs that begin at `first` and one run later become one.
template <OrderSink<PaintersSort> Sink>
void merge_runs(PaintersSort& sort, std::size_t first, Sink& sink) {
    const std::size_t middle = std::min(first + sort.run, sort.list.size());
    const std::size_t last = std::min(middle + sort.run, sort.list.size());
    std::size_t left = first;
    std::size_t right = middle;
    while (left < middle && right < last) {
        // Only a farther one overtakes: equal keys keep their order
        const bool overtakes = is_farther(sort, sort.list[right], sort.list[left], sink);
        move(sort, sort.list[overtakes ? right++ : left++], sink);
    }
    while (left < middle) {
        move(sort, sort.list[left++], sink);
    }
    while (right < last) {
        move(sort, sort.list[right++], sink);
    }
}

} // namespace painters_steps

/// `order` of the result holds every polygon once, farthest first.
template <OrderSink<PaintersSort> Sink>
[[nodiscard]] PaintersSort
sort_painters(std::vector<WindowPolygon> polygons, scene::PaintersKey key, Sink& sink) {
    namespace steps = painters_steps;
    PaintersSort sort;
    for (const WindowPolygon& polygon : polygons) {
        sort.list.push_back(static_cast<std::int32_t>(sort.keys.size()));
        sort.keys.push_back(painters_key(polygon, key));
    }
    sort.polygons = std::move(polygons);

    // Merge runs of 1, then of 2, of 4 …, until one run is left
    for (std::int32_t pass = 0; sort.run < sort.list.size(); ++pass, sort.run *= 2) {
        sink.order_step(
            {.kind = OrderEventKind::iteration,
             .place = pass,
             .value = static_cast<double>(sort.run)},
            sort
        );
        for (std::size_t first = 0; first < sort.list.size(); first += 2 * sort.run) {
            steps::merge_runs(sort, first, sink);
        }
        sort.list.swap(sort.moved);
        sort.moved.clear();
    }

    // Draw from the head of the list
    for (const std::int32_t polygon : sort.list) {
        const auto place = static_cast<std::int32_t>(sort.order.size());
        sort.order.push_back(polygon);
        sink.order_step(
            {.kind = OrderEventKind::emit,
             .polygon = polygon,
             .place = place,
             .value = sort.key(polygon)},
            sort
        );
    }
    return sort;
}

} // namespace hs::visibility
