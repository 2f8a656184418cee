// What the visible-surface algorithms spend over the number of polygons: the tables of
// docs/visibility.md. Prints, and takes a minute: run as `halfspace_tests [visibility-cost]`.
#include "core/scene/mesh_file.hpp"
#include "core/scene/triangulate.hpp"
#include "core/visibility/bsp.hpp"
#include "core/visibility/depth_sort.hpp"
#include "core/visibility/front_lists.hpp"
#include "core/visibility/octree.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/visible_surfaces.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cmath>
#include <iostream>
#include <string>

using namespace hs;
using visibility::OrderEventKind;
using visibility::WindowPolygon;
using visibility::WorldPolygon;

namespace {

struct Counter {
    std::array<std::int64_t, 64> counts{};
    template <typename State>
    void order_step(const visibility::OrderEvent& event, const State&) {
        ++counts[static_cast<std::size_t>(event.kind)];
    }
    [[nodiscard]] std::int64_t of(OrderEventKind kind) const {
        return counts[static_cast<std::size_t>(kind)];
    }
};

/// Calls `run(counter)` and prints its counts with the time it took.
template <typename Run>
void measure(const std::string& name, std::size_t polygons, Run&& run) {
    Counter counter;
    const auto start = std::chrono::steady_clock::now();
    const std::string counts = run(counter);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    std::cout << fmt::format("{:22} {:7} {} {:.3f} s\n", name, polygons, counts, time.count());
}

void measure_window(const std::string& name, const std::vector<WindowPolygon>& polygons) {
    if (visibility::estimate_front_lists(polygons.size()) < 1.0e9) {
        measure(name + ", front lists", polygons.size(), [&](Counter& counter) {
            const auto lists = visibility::order_by_front_lists(polygons, counter);
            return fmt::format(
                "pairs {} overlapping {} iterations {} stuck {}",
                counter.of(OrderEventKind::overlap),
                counter.of(OrderEventKind::nearer),
                lists.iterations,
                lists.stuck.size()
            );
        });
    }
    if (visibility::estimate_depth_sort(polygons) < 3.0e8) {
        measure(name + ", depth sort", polygons.size(), [&](Counter& counter) {
            const auto sort = visibility::sort_by_depth(polygons, counter);
            return fmt::format(
                "estimate {} tests {} moves {} splits {} anyway {}",
                visibility::estimate_depth_sort(polygons),
                counter.of(OrderEventKind::test),
                counter.of(OrderEventKind::move),
                sort.splits,
                counter.of(OrderEventKind::draw_anyway)
            );
        });
    }
}

void measure_world(const std::string& name, const std::vector<WorldPolygon>& polygons) {
    using visibility::Splitter;
    const std::array<std::pair<Splitter, const char*>, 3> splitters{
        {{Splitter::first, "first"},
         {Splitter::random, "random"},
         {Splitter::fewest_splits, "fewest"}}};
    for (const auto& [splitter, splitter_name] : splitters) {
        const visibility::BspOptions options{splitter, 1};
        const double estimate = visibility::estimate_bsp(polygons, options);
        if (estimate > 2.0e9) {
            std::cout << name << " BSP " << splitter_name << ": estimate " << estimate << "\n";
            continue;
        }
        measure(name + ", BSP " + splitter_name, polygons.size(), [&](Counter& counter) {
            const auto tree = visibility::build_bsp(polygons, options, counter);
            return fmt::format(
                "estimate {:.0f} classified {} splits {} nodes {}",
                estimate,
                counter.of(OrderEventKind::classify),
                tree.splits,
                tree.nodes.size()
            );
        });
    }
    measure(name + ", octree", polygons.size(), [&](Counter& counter) {
        const auto tree = visibility::build_octree(polygons, {}, counter);
        return fmt::format(
            "cells {} splits {} parts {}", tree.cells.size(), tree.splits, tree.set.size()
        );
    });
}

/// Seen from distance 3 in front, in a window of 100 × 100 pixels.
glm::dvec3 in_window(const glm::dvec3& p) {
    const double inverse = 1.0 / (3.0 - p.z);
    return {50.0 + 120.0 * p.x * inverse, 50.0 - 120.0 * p.y * inverse, 2.0 - 4.0 * inverse};
}

} // namespace

TEST_CASE("what visible-surface algorithms spend", "[.][visibility-cost]") {
    for (const std::uint32_t count : {10U, 100U, 1000U, 10'000U, 100'000U}) {
        tests::Random random(7);
        const float size = 1.0F / std::sqrt(static_cast<float>(count)); // covers the same
        const auto world = tests::random_world_triangles(count, size, random);
        std::vector<WindowPolygon> window;
        for (const WorldPolygon& triangle : world) {
            window.push_back(tests::window_triangle(
                triangle.triangle,
                in_window(triangle.corners[0].position),
                in_window(triangle.corners[1].position),
                in_window(triangle.corners[2].position)
            ));
        }
        measure_window("soup", window);
        measure_world("soup", world);
    }
    for (const std::string name : {"teapot.obj", "spot.obj", "stanford-bunny.obj"}) {
        const auto path = test::data_file(name);
        if (!path) {
            WARN("not measured: " + name + " is not there");
            continue;
        }
        auto mesh = scene::load_mesh(*path);
        REQUIRE(mesh);
        scene::fit_to_unit_sphere(*mesh);
        std::vector<WindowPolygon> window;
        std::vector<WorldPolygon> world;
        for (std::uint32_t i = 0; i < mesh->triangles.size(); ++i) {
            const auto at = [&](int k) {
                return glm::dvec3{mesh->positions[mesh->triangles[i][k]]};
            };
            world.push_back(tests::world_triangle(i, at(0), at(1), at(2)));
            window.push_back(
                tests::window_triangle(i, in_window(at(0)), in_window(at(1)), in_window(at(2)))
            );
        }
        measure_window(name, window);
        measure_world(name, world);
    }
}
