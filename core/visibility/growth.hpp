// What an algorithm will cost, from what it costs on parts of its input: some costs depend on the
// polygons and not only on their number, and running the algorithm is the only way to know.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace hs::visibility {

/// `count` polygons spread evenly over a list.
template <typename Polygon>
[[nodiscard]] std::vector<Polygon> sample_of(std::span<const Polygon> polygons, std::size_t count) {
    std::vector<Polygon> sample;
    for (std::size_t k = 0; k < count; ++k) {
        sample.push_back(polygons[k * polygons.size() / count]);
    }
    return sample;
}

/// `cost(k)` measures a sample of k. Samples double until one has cost enough to tell; from the
/// last doublings the cost of all is extrapolated as a power of their number, between 1 and 4 (a
/// plane for every polygon, n, and parts, n³ at most, cut by each). Exact when all cost little.
template <typename Cost>
[[nodiscard]] double extrapolate_cost(std::size_t count, Cost&& cost) {
    constexpr std::size_t smallest = 16;
    constexpr double enough = 1.0e6; // some hundredths of a second
    std::size_t size = std::min(count, smallest);
    double before = 1.0; // two doublings ago
    double last = 1.0;
    double now = std::max(cost(size), 1.0);
    while (size < count && (now < enough || size < 4 * smallest)) {
        size = std::min(2 * size, count);
        before = last;
        last = now;
        now = std::max(cost(size), 1.0);
    }
    if (size == count) {
        return now;
    }
    const double power = std::clamp(0.5 * std::log2(now / before), 1.0, 4.0);
    return now * std::pow(static_cast<double>(count) / static_cast<double>(size), power);
}

} // namespace hs::visibility
