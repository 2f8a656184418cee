// Visible surfaces: every order, painted, shows the nearest triangle; cutting loses nothing; what
// cannot be ordered is exactly what lies on cycles.
#include "tests/support/visible_surfaces.hpp"

#include "core/visibility/bsp_walk.hpp"
#include "core/visibility/depth_sort.hpp"
#include "core/visibility/front_lists.hpp"
#include "core/visibility/octree_walk.hpp"
#include "tests/support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

using namespace hs;
using visibility::WindowPolygon;

namespace {

constexpr double edge_margin = 1.0 / 256.0; ///< in pixels: half of what snapping can move an edge
constexpr double depth_margin = 4.0e-7;     ///< as in the comparison with Embree

struct Tally {
    int asked = 0;
    int wrong = 0;
};

/// Paints in `order` at random points and compares with the nearest of the triangles given.
void compare(
    std::span<const WindowPolygon> given,
    std::span<const WindowPolygon> parts,
    std::span<const std::int32_t> order,
    tests::Random& random,
    Tally& tally
) {
    for (int i = 0; i < 500; ++i) {
        const glm::dvec2 point{random.between(0.0F, 100.0F), random.between(0.0F, 100.0F)};
        const auto nearest = tests::nearest_at(given, point, edge_margin, depth_margin);
        const auto painted = tests::painted_at(parts, order, point, edge_margin);
        if (nearest && painted) {
            ++tally.asked;
            tally.wrong += *nearest == *painted ? 0 : 1;
        }
    }
}

template <typename Space>
glm::dvec3
from_weights(const visibility::Corner<Space>& corner, const visibility::Polygon<Space>& triangle) {
    return corner.weights.x * triangle.corners[0].position +
           corner.weights.y * triangle.corners[1].position +
           corner.weights.z * triangle.corners[2].position;
}

/// Are there polygons in front of each other in a circle? Tarjan, Depth-First Search and Linear
/// Graph Algorithms, 1972.
class CycleSearch {
public:
    explicit CycleSearch(const std::vector<std::vector<std::int32_t>>& after)
        : after_(after), index_(after.size(), -1), low_(after.size()), on_stack_(after.size()) {
        for (std::size_t i = 0; i < after.size(); ++i) {
            if (index_[i] < 0) {
                visit(i);
            }
        }
    }
    [[nodiscard]] bool found() const { return found_; }

private:
    void visit(std::size_t i) {
        index_[i] = low_[i] = next_++;
        stack_.push_back(i);
        on_stack_[i] = true;
        for (const std::int32_t j : after_[i]) {
            const auto k = static_cast<std::size_t>(j);
            if (index_[k] < 0) {
                visit(k);
                low_[i] = std::min(low_[i], low_[k]);
            } else if (on_stack_[k]) {
                low_[i] = std::min(low_[i], index_[k]);
            }
        }
        if (low_[i] == index_[i]) {
            found_ = found_ || stack_.back() != i;
            std::size_t popped = i + 1;
            while (popped != i) {
                popped = stack_.back();
                stack_.pop_back();
                on_stack_[popped] = false;
            }
        }
    }

    const std::vector<std::vector<std::int32_t>>& after_;
    std::vector<int> index_;
    std::vector<int> low_;
    std::vector<bool> on_stack_;
    std::vector<std::size_t> stack_;
    int next_ = 0;
    bool found_ = false;
};

} // namespace

TEST_CASE("depth sort, painted, shows the nearest triangle everywhere", "[property][visibility]") {
    tests::Random random(401);
    visibility::SilentOrder silent;
    Tally tally;
    int splits = 0;
    for (int round = 0; round < 200; ++round) {
        const auto given =
            tests::random_window_triangles(2 + random.below(30), random.between(5, 60), random);
        const auto sort = visibility::sort_by_depth(given, silent);
        compare(given, sort.set.polygons, sort.order, random, tally);
        splits += sort.splits;
    }
    CHECK(tally.wrong == 0);
    CHECK(tally.asked > 80'000);
    CHECK(splits > 1000);
}

TEST_CASE("depth sort puts any two polygons in order wherever both are", "[property][visibility]") {
    tests::Random random(409);
    visibility::SilentOrder silent;
    Tally tally;
    for (int round = 0; round < 200; ++round) {
        const auto given =
            tests::random_window_triangles(2 + random.below(30), random.between(5, 60), random);
        const auto sort = visibility::sort_by_depth(given, silent);
        for (int i = 0; i < 200; ++i) {
            const glm::dvec2 point{random.between(0.0F, 100.0F), random.between(0.0F, 100.0F)};
            const auto sorted = tests::back_to_front_at(
                given, sort.set.polygons, sort.order, point, edge_margin, depth_margin
            );
            tally.asked += sorted ? 1 : 0;
            tally.wrong += sorted && !*sorted ? 1 : 0;
        }
    }
    CHECK(tally.wrong == 0);
    CHECK(tally.asked > 30'000);
}

TEST_CASE("cutting keeps the area, the weights and the plane", "[property][visibility]") {
    tests::Random random(402);
    visibility::SilentOrder silent;
    double worst_area = 0.0;
    double worst_weights = 0.0;
    double worst_position = 0.0;
    int parts = 0;
    for (int round = 0; round < 100; ++round) {
        const auto given = tests::random_window_triangles(20, 60.0F, random);
        const auto sort = visibility::sort_by_depth(given, silent);
        std::vector<double> areas(given.size());
        for (const WindowPolygon& part : sort.set.polygons) {
            parts += part.split ? 1 : 0;
            areas[part.triangle] += visibility::area(part);
            for (const auto& corner : part.corners) {
                const glm::dvec3& w = corner.weights;
                const glm::dvec3 expected = from_weights(corner, given[part.triangle]);
                worst_weights = std::max(worst_weights, std::fabs(w.x + w.y + w.z - 1.0));
                worst_position = std::max(
                    worst_position, glm::length(corner.position - expected) / tests::window_size
                );
            }
        }
        for (std::size_t i = 0; i < given.size(); ++i) {
            const double lost = std::fabs(areas[i] - visibility::area(given[i]));
            worst_area = std::max(worst_area, lost / (tests::window_size * tests::window_size));
        }
    }
    // A corner is cut again at most a few dozen times, with a few roundings each
    constexpr double rounding = 256.0 * 0x1p-53;
    CHECK(parts > 2000);
    CHECK(worst_area <= rounding);
    CHECK(worst_weights <= rounding);
    CHECK(worst_position <= rounding);
}

TEST_CASE("front lists are stuck exactly when there is a cycle", "[property][visibility]") {
    tests::Random random(403);
    visibility::SilentOrder silent;
    int stuck = 0;
    int wrong = 0;
    constexpr int rounds = 400;
    for (int round = 0; round < rounds; ++round) {
        const auto given =
            tests::random_window_triangles(5 + random.below(25), random.between(20, 60), random);
        const auto lists = visibility::order_by_front_lists(given, silent);
        const bool cycle = CycleSearch(lists.in_front).found();
        stuck += lists.stuck.empty() ? 0 : 1;
        wrong += cycle == lists.stuck.empty() ? 1 : 0;
        wrong += lists.order.size() + lists.stuck.size() == given.size() ? 0 : 1;
    }
    CHECK(wrong == 0);
    CHECK(stuck > rounds / 10);
    CHECK(stuck < rounds - rounds / 10);
}

TEST_CASE(
    "front lists, painted, show the nearest of triangles that do not penetrate",
    "[property][visibility]"
) {
    tests::Random random(404);
    visibility::SilentOrder silent;
    Tally tally;
    for (int round = 0; round < 200; ++round) {
        // Every triangle leans within a layer of its own
        auto given = tests::random_window_triangles(20, 40.0F, random);
        std::vector<std::uint32_t> layers(given.size());
        std::iota(layers.begin(), layers.end(), 0U);
        for (std::size_t i = 0; i < given.size(); ++i) {
            std::swap(
                layers[i], layers[i + random.below(static_cast<std::uint32_t>(given.size() - i))]
            );
            for (auto& corner : given[i].corners) {
                corner.position.z = (layers[i] + corner.position.z) / 20.0;
            }
        }
        const auto lists = visibility::order_by_front_lists(given, silent);
        REQUIRE(lists.stuck.empty());
        compare(given, lists.polygons, lists.order, random, tally);
    }
    CHECK(tally.wrong == 0);
    CHECK(tally.asked > 80'000);
}

namespace {

/// Some eyes: among the triangles, outside, and infinitely far away.
std::vector<glm::dvec4> random_eyes(tests::Random& random) {
    const auto coordinate = [&] { return static_cast<double>(random.between(-1.0F, 1.0F)); };
    std::vector<glm::dvec4> eyes;
    for (const double reach : {1.0, 5.0}) {
        eyes.emplace_back(reach * coordinate(), reach * coordinate(), reach * coordinate(), 1.0);
    }
    const glm::dvec3 direction{coordinate(), coordinate(), coordinate()};
    eyes.emplace_back(glm::normalize(direction), 0.0);
    return eyes;
}

/// Looks along rays: is the first polygon met in a front-to-back order of the nearest triangle?
void look(
    std::span<const visibility::WorldPolygon> given,
    std::span<const visibility::WorldPolygon> parts,
    std::span<const std::int32_t> front_to_back,
    const glm::dvec4& eye,
    tests::Random& random,
    Tally& tally
) {
    constexpr double margin = 1.0e-5; // of the cube's half side: tens of tolerances
    for (int i = 0; i < 100; ++i) {
        const tests::Ray ray = tests::random_ray(eye, random);
        const auto nearest = tests::nearest_met(given, ray, margin);
        const auto first = tests::first_met(parts, front_to_back, ray, margin);
        if (nearest && first) {
            ++tally.asked;
            tally.wrong += *nearest == *first ? 0 : 1;
        }
    }
}

} // namespace

TEST_CASE("one BSP tree shows the nearest triangle from every eye", "[property][visibility]") {
    using visibility::WalkOrder;
    tests::Random random(405);
    visibility::SilentOrder silent;
    Tally tally;
    int splits = 0;
    int not_reversed = 0;
    for (int round = 0; round < 60; ++round) {
        const auto given =
            tests::random_world_triangles(2 + random.below(40), random.between(0.1F, 1.0F), random);
        const auto splitter = static_cast<visibility::Splitter>(round % 3);
        const auto tree = visibility::build_bsp(given, {splitter, random.next()}, silent);
        splits += tree.splits;
        for (const glm::dvec4& eye : random_eyes(random)) {
            const auto near = visibility::walk_bsp(tree, eye, WalkOrder::front_to_back, silent);
            auto far = visibility::walk_bsp(tree, eye, WalkOrder::back_to_front, silent);
            std::ranges::reverse(far.order);
            not_reversed += near.order == far.order ? 0 : 1;
            look(given, tree.set.polygons, near.order, eye, random, tally);
        }
    }
    CHECK(tally.wrong == 0);
    CHECK(tally.asked > 10'000);
    CHECK(splits > 1000);
    CHECK(not_reversed == 0);
}

TEST_CASE("a BSP walk puts any two polygons in order on every ray", "[property][visibility]") {
    tests::Random random(410);
    visibility::SilentOrder silent;
    Tally tally;
    for (int round = 0; round < 60; ++round) {
        const auto given =
            tests::random_world_triangles(2 + random.below(40), random.between(0.1F, 1.0F), random);
        const auto splitter = static_cast<visibility::Splitter>(round % 3);
        const auto tree = visibility::build_bsp(given, {splitter, random.next()}, silent);
        for (const glm::dvec4& eye : random_eyes(random)) {
            const auto walk =
                visibility::walk_bsp(tree, eye, visibility::WalkOrder::front_to_back, silent);
            for (int i = 0; i < 50; ++i) {
                const tests::Ray ray = tests::random_ray(eye, random);
                const auto sorted =
                    tests::front_to_back_along(tree.set.polygons, walk.order, ray, 1.0e-5);
                tally.asked += sorted ? 1 : 0;
                tally.wrong += sorted && !*sorted ? 1 : 0;
            }
        }
    }
    CHECK(tally.wrong == 0);
    CHECK(tally.asked > 5'000);
}

TEST_CASE("every node of a BSP tree has its subtrees on its two sides", "[property][visibility]") {
    tests::Random random(406);
    visibility::SilentOrder silent;
    int wrong = 0;
    int nodes = 0;
    for (int round = 0; round < 30; ++round) {
        const auto given = tests::random_world_triangles(40, 0.8F, random);
        const auto splitter = static_cast<visibility::Splitter>(round % 3);
        const auto tree = visibility::build_bsp(given, {splitter, random.next()}, silent);
        nodes += static_cast<int>(tree.nodes.size());
        // From every node up: on its side of all planes above it
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
            auto child = static_cast<std::int32_t>(i);
            for (std::int32_t up = tree.nodes[i].parent; up >= 0;) {
                const visibility::BspNode& above = tree.nodes[static_cast<std::size_t>(up)];
                const auto side =
                    above.front == child ? visibility::Side::front : visibility::Side::back;
                for (const std::int32_t polygon : tree.nodes[i].polygons) {
                    wrong += visibility::classify(above.plane, tree.set.polygon(polygon)) == side
                                 ? 0
                                 : 1;
                }
                child = up;
                up = above.parent;
            }
        }
    }
    CHECK(wrong == 0);
    CHECK(nodes > 2000);
}

TEST_CASE(
    "an octree shows the nearest triangle wherever its leaves decide", "[property][visibility]"
) {
    tests::Random random(407);
    visibility::SilentOrder silent;
    Tally decided;
    int undecided = 0;
    int splits = 0;
    for (int round = 0; round < 60; ++round) {
        const auto given =
            tests::random_world_triangles(2 + random.below(40), random.between(0.1F, 0.6F), random);
        const auto depth = static_cast<std::int32_t>(random.below(6));
        const auto tree = visibility::build_octree(given, {.occupancy = 3, .depth = depth}, silent);
        splits += tree.splits;
        for (const glm::dvec4& eye : random_eyes(random)) {
            const auto walk = visibility::walk_octree(tree, eye, silent);
            undecided += walk.undecided > 0 ? 1 : 0;
            if (walk.undecided == 0) {
                look(given, tree.set.polygons, walk.order, eye, random, decided);
            }
        }
    }
    CHECK(decided.wrong == 0);
    CHECK(decided.asked > 3'000);
    CHECK(splits > 1000);
    CHECK(undecided > 10); // triangles penetrate each other
}

TEST_CASE("an octree keeps every part in one leaf and all of the area", "[property][visibility]") {
    tests::Random random(408);
    visibility::SilentOrder silent;
    int outside = 0;
    double worst = 0.0;
    for (int round = 0; round < 20; ++round) {
        const auto given = tests::random_world_triangles(30, 0.5F, random);
        const auto tree = visibility::build_octree(given, {}, silent);
        std::vector<int> leaves(tree.set.polygons.size());
        std::vector<double> areas(given.size());
        for (const visibility::OctreeCell& cell : tree.cells) {
            for (const std::int32_t i : cell.polygons) {
                ++leaves[static_cast<std::size_t>(i)];
                areas[tree.set.polygon(i).triangle] += visibility::area(tree.set.polygon(i));
                for (const auto& corner : tree.set.polygon(i).corners) {
                    const glm::dvec3 away = glm::abs(corner.position - cell.middle);
                    const double reach = cell.half_side + 1.0e-6;
                    outside += away.x > reach || away.y > reach || away.z > reach ? 1 : 0;
                }
            }
        }
        outside += static_cast<int>(
            leaves.size() - static_cast<std::size_t>(std::ranges::count(leaves, 1))
        );
        for (std::size_t i = 0; i < given.size(); ++i) {
            worst = std::max(worst, std::fabs(areas[i] - visibility::area(given[i])));
        }
    }
    CHECK(outside == 0);
    CHECK(worst <= 256.0 * 0x1p-53);
}
