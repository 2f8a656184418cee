// Newell, Newell and Sancha's five tests: may P be drawn before Q? Each is a reason why P cannot
// hide any of Q; the cheapest is asked first.
//
// Newell, Newell and Sancha, A Solution to the Hidden Surface Problem, 1972.
#pragma once

#include "core/visibility/order_trace.hpp"
#include "core/visibility/overlap.hpp"
#include "core/visibility/polygon_set.hpp"

namespace hs::visibility {

/// What the tests know of a polygon besides its corners.
struct SortedPolygon {
    Extents extents;
    bool marked = false; ///< was moved ahead of another since it was made
};

/// An answer and the numbers it came from.
struct NewellAnswer {
    bool passed = false;
    Side side = Side::on;     ///< plane tests: of the polygon that is asked
    double value = 0.0;       ///< depth: nearest of P; x and y: the gap between the extents
    double other_value = 0.0; ///< depth: farthest of Q
};

/// Asks one test. Planes must have the eye in front. Coplanar polygons pass the plane tests: they
/// cannot hide each other.
[[nodiscard]] inline NewellAnswer
ask(NewellTest test,
    const PolygonSet<WindowSpace>& set,
    const std::vector<SortedPolygon>& sorted,
    std::int32_t p,
    std::int32_t q) {
    const Extents& extents_p = sorted[static_cast<std::size_t>(p)].extents;
    const Extents& extents_q = sorted[static_cast<std::size_t>(q)].extents;
    switch (test) {
    case NewellTest::depth_extents:
        return {
            .passed = extents_p.low.z >= extents_q.high.z,
            .value = extents_p.low.z,
            .other_value = extents_q.high.z};
    case NewellTest::x_extents:
    case NewellTest::y_extents: {
        const double space = gap(extents_p, extents_q, test == NewellTest::x_extents ? 0 : 1);
        return {.passed = space >= 0.0, .value = space};
    }
    case NewellTest::behind_plane: {
        const Side side = classify(set.plane(q), set.polygon(p));
        return {.passed = side == Side::back || side == Side::on, .side = side};
    }
    case NewellTest::in_front_of_plane: {
        const Side side = classify(set.plane(p), set.polygon(q));
        return {.passed = side == Side::front || side == Side::on, .side = side};
    }
    case NewellTest::projections:
        return {.passed = !projections_overlap(set.polygon(p), set.polygon(q), set.reach)};
    }
    HS_CHECK(false, "every test is asked above");
    return {};
}

} // namespace hs::visibility
