#include "core/visibility/depth_sort.hpp"

#include <algorithm>
#include <numeric>

namespace hs::visibility {

namespace {

double farthest(const DepthSort& sort, std::int32_t i) {
    return sort.sorted[static_cast<std::size_t>(i)].extents.high.z;
}

/// Behind those that are as far.
void put_in(DepthSort& sort, std::int32_t i) {
    const auto tail = sort.list.begin() + static_cast<std::ptrdiff_t>(sort.chain);
    const auto place = std::upper_bound(
        tail,
        sort.list.end(),
        farthest(sort, i),
        [&](double depth, std::int32_t other) { return depth > farthest(sort, other); }
    );
    sort.list.insert(place, i);
}

bool cuts(const DepthSort& sort, std::int32_t by, std::int32_t polygon) {
    return classify(sort.set.plane(by), sort.set.polygon(polygon)) == Side::spanning;
}

} // namespace

double estimate_depth_sort(std::span<const WindowPolygon> polygons) {
    // In the order of farthest depths, P overlaps those that follow it up to its own nearest depth
    std::vector<double> far;
    for (const WindowPolygon& polygon : polygons) {
        far.push_back(extents_of(polygon).high.z);
    }
    std::ranges::sort(far);
    double pairs = 0.0;
    for (const WindowPolygon& polygon : polygons) {
        const Extents extents = extents_of(polygon);
        const auto first = std::ranges::upper_bound(far, extents.low.z);
        const auto last = std::ranges::lower_bound(far, extents.high.z);
        pairs += static_cast<double>(std::max(last - first, std::ptrdiff_t{0}));
    }
    return pairs;
}

DepthSort begin_depth_sort(std::vector<WindowPolygon> polygons) {
    DepthSort sort;
    sort.set = polygon_set(std::move(polygons));
    for (WindowPlane& plane : sort.set.planes) {
        plane = facing_the_eye(plane);
    }
    for (const WindowPolygon& polygon : sort.set.polygons) {
        sort.sorted.push_back({extents_of(polygon), false});
    }
    sort.list.resize(sort.sorted.size());
    std::iota(sort.list.begin(), sort.list.end(), 0);
    std::ranges::stable_sort(sort.list, [&](std::int32_t a, std::int32_t b) {
        return farthest(sort, a) > farthest(sort, b);
    });
    return sort;
}

void move_to_head(DepthSort& sort, std::size_t place) {
    const auto begin = sort.list.begin();
    const auto moved = begin + static_cast<std::ptrdiff_t>(place);
    sort.sorted[static_cast<std::size_t>(*moved)].marked = true;
    sort.chain += place < sort.chain ? 0U : 1U;
    std::rotate(begin, moved, moved + 1);
}

std::int32_t cut(DepthSort& sort, std::int32_t i, std::int32_t by) {
    const WindowPlane plane = sort.set.plane(by);
    const std::int32_t part = split(sort.set, i, plane);
    sort.sorted.emplace_back();
    for (const std::int32_t half : {i, part}) {
        sort.sorted[static_cast<std::size_t>(half)].extents = extents_of(sort.set.polygon(half));
    }
    ++sort.splits;

    // Start over: what was moved goes back to where its depth belongs, and so do the parts
    std::vector<std::int32_t> moved{part};
    const auto end_of_chain = sort.list.begin() + static_cast<std::ptrdiff_t>(sort.chain);
    moved.insert(moved.end(), sort.list.begin(), end_of_chain);
    sort.list.erase(sort.list.begin(), end_of_chain);
    sort.chain = 0;
    if (const auto found = std::ranges::find(sort.list, i); found != sort.list.end()) {
        sort.list.erase(found);
        moved.push_back(i);
    }
    for (const std::int32_t polygon : moved) {
        sort.sorted[static_cast<std::size_t>(polygon)].marked = false;
        put_in(sort, polygon);
    }
    return part;
}

Cut choose_cut(const DepthSort& sort, std::size_t place) {
    const std::int32_t p = sort.list.front();
    const std::int32_t q = sort.list[place];
    if (cuts(sort, p, q)) {
        return {q, p};
    }
    if (cuts(sort, q, p)) {
        return {p, q};
    }
    for (std::size_t a = 0; a <= place; ++a) {
        for (std::size_t b = 0; b <= place; ++b) {
            if (cuts(sort, sort.list[b], sort.list[a])) {
                return {sort.list[a], sort.list[b]};
            }
        }
    }
    return {};
}

} // namespace hs::visibility
