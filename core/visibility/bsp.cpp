#include "core/visibility/bsp.hpp"

#include <algorithm>
#include <cmath>

namespace hs::visibility {

std::uint64_t next_random(std::uint64_t& state) {
    state += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31U);
}

std::vector<std::int32_t> candidate_places(std::int32_t count) {
    const std::int32_t asked = std::min(count, max_candidates);
    std::vector<std::int32_t> places;
    for (std::int64_t k = 0; k < asked; ++k) {
        places.push_back(static_cast<std::int32_t>(k * count / asked));
    }
    return places;
}

std::int32_t
count_splits(const BspTree& tree, std::span<const std::int32_t> list, std::int32_t splitter) {
    const auto spans = [&](std::int32_t i) {
        return classify(tree.set.plane(splitter), tree.set.polygon(i)) == Side::spanning;
    };
    return static_cast<std::int32_t>(std::ranges::count_if(list, spans));
}

std::size_t first_with_area(const BspTree& tree, std::span<const std::int32_t> list) {
    const auto found =
        std::ranges::find_if(list, [&](std::int32_t i) { return has_area(tree.set.plane(i)); });
    return found == list.end() ? 0 : static_cast<std::size_t>(found - list.begin());
}

namespace {

struct QuestionCount {
    double count = 0.0;
    void order_step(const OrderEvent& event, const BspTree&) {
        count += event.kind == OrderEventKind::classify    ? 1.0
                 : event.kind == OrderEventKind::candidate ? event.other_value
                                                           : 0.0;
    }
};

/// Questions for a tree of `count` polygons spread evenly over the list.
double
sample_cost(std::span<const WorldPolygon> polygons, std::size_t count, const BspOptions& options) {
    std::vector<WorldPolygon> sample;
    for (std::size_t k = 0; k < count; ++k) {
        sample.push_back(polygons[k * polygons.size() / count]);
    }
    QuestionCount questions;
    static_cast<void>(build_bsp(std::move(sample), options, questions));
    return questions.count;
}

} // namespace

double estimate_bsp(std::span<const WorldPolygon> polygons, const BspOptions& options) {
    constexpr std::size_t small = 256;
    constexpr std::size_t large = 2048;
    if (polygons.size() <= large) {
        return sample_cost(polygons, polygons.size(), options);
    }
    const double cost = sample_cost(polygons, large, options);
    const double growth = cost / std::max(sample_cost(polygons, small, options), 1.0);
    const double power = std::log(growth) / std::log(static_cast<double>(large) / small);
    const double times = static_cast<double>(polygons.size()) / large;
    return cost * std::pow(times, std::clamp(power, 1.0, 2.0));
}

} // namespace hs::visibility
