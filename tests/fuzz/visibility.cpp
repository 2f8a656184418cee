// Any triangles, in every order there is: each algorithm ends, draws every part once, loses no
// area, and puts what is farther first.
#include "core/base/check.hpp"
#include "core/visibility/bsp_walk.hpp"
#include "core/visibility/depth_sort.hpp"
#include "core/visibility/front_lists.hpp"
#include "core/visibility/octree_walk.hpp"
#include "tests/fuzz/bytes.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/support/visible_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

using namespace hs;
using visibility::WindowPolygon;
using visibility::WorldPolygon;

namespace {

/// A window of 100 × 100 pixels with depths from 0 to 1, on a lattice where much coincides, or any
/// finite numbers.
double take_coordinate(fuzz::Bytes& bytes, bool wild, double largest) {
    if (wild) {
        const auto value = bytes.take<float>();
        return std::isfinite(value) ? static_cast<double>(value) : 0.0;
    }
    return bytes.take<std::uint8_t>() % 17 / 16.0 * largest;
}

std::vector<WindowPolygon> take_triangles(fuzz::Bytes& bytes, bool wild) {
    std::vector<WindowPolygon> triangles;
    while (!bytes.empty() && triangles.size() < 16) {
        glm::dvec3 corners[3];
        for (glm::dvec3& corner : corners) {
            corner.x = take_coordinate(bytes, wild, 100.0);
            corner.y = take_coordinate(bytes, wild, 100.0);
            corner.z = take_coordinate(bytes, wild, 1.0);
        }
        const auto number = static_cast<std::uint32_t>(triangles.size());
        triangles.push_back(tests::window_triangle(number, corners[0], corners[1], corners[2]));
    }
    return triangles;
}

/// The same triangles in the cube from 0 to 1.
std::vector<WorldPolygon> in_world(const std::vector<WindowPolygon>& triangles, bool wild) {
    std::vector<WorldPolygon> result;
    const glm::dvec3 scale = wild ? glm::dvec3{1.0} : glm::dvec3{0.01, 0.01, 1.0};
    for (const WindowPolygon& triangle : triangles) {
        const auto at = [&](std::size_t k) { return scale * triangle.corners[k].position; };
        result.push_back(tests::world_triangle(triangle.triangle, at(0), at(1), at(2)));
    }
    return result;
}

/// Every polygon once, and no area lost.
template <typename Space>
void check_parts(
    const std::vector<visibility::Polygon<Space>>& given,
    const visibility::PolygonSet<Space>& set,
    std::vector<std::int32_t> order
) {
    std::ranges::sort(order);
    bool all = static_cast<std::int32_t>(order.size()) == set.size();
    for (std::size_t i = 0; all && i < order.size(); ++i) {
        all = order[i] == static_cast<std::int32_t>(i);
    }
    HS_CHECK(all, "every part is drawn once");
    std::vector<double> areas(given.size());
    for (const visibility::Polygon<Space>& part : set.polygons) {
        areas[part.triangle] += visibility::area(part);
    }
    const double reach = set.reach.x + set.reach.y + set.reach.z;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const double lost = std::fabs(areas[i] - visibility::area(given[i]));
        HS_CHECK(lost <= 1.0e-12 * reach * reach, "the parts have the area of the whole");
    }
}

void check_window_orders(const std::vector<WindowPolygon>& triangles, bool wild) {
    visibility::SilentOrder silent;
    const auto sort = visibility::sort_by_depth(triangles, silent);
    check_parts(triangles, sort.set, sort.order);
    for (int i = 0; !wild && i < 100; ++i) {
        const glm::dvec2 point{i % 10 * 10.0 + 3.3, i / 10 * 10.0 + 4.7};
        const auto sorted = tests::back_to_front_at(
            triangles, sort.set.polygons, sort.order, point, 1.0 / 256.0, 4.0e-7
        );
        HS_CHECK(sorted.value_or(true), "what is farther is drawn first");
    }
    const auto lists = visibility::order_by_front_lists(triangles, silent);
    HS_CHECK(
        lists.order.size() + lists.stuck.size() == triangles.size(), "a polygon is drawn or stuck"
    );
}

void check_world_orders(
    const std::vector<WorldPolygon>& triangles,
    const glm::dvec4& eye,
    std::uint8_t choice,
    bool wild
) {
    visibility::SilentOrder silent;
    const auto splitter = static_cast<visibility::Splitter>(choice % 3);
    const auto tree = visibility::build_bsp(triangles, {splitter, choice}, silent);
    const auto walk = visibility::walk_bsp(tree, eye, visibility::WalkOrder::front_to_back, silent);
    check_parts(triangles, tree.set, walk.order);
    for (int i = 0; !wild && i < 64; ++i) {
        const glm::dvec3 target{i % 4 * 0.26 + 0.1, i / 4 % 4 * 0.26 + 0.09, i / 16 * 0.26 + 0.11};
        const tests::Ray ray{glm::dvec3{eye}, target - glm::dvec3{eye}};
        const auto sorted = tests::front_to_back_along(tree.set.polygons, walk.order, ray, 1.0e-5);
        HS_CHECK(sorted.value_or(true), "a ray meets what is nearer first");
    }
    const auto cells = visibility::build_octree(triangles, {.max_parts = 5000}, silent);
    check_parts(triangles, cells.set, visibility::walk_octree(cells, eye, silent).order);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Bytes bytes(data, size);
    const auto choice = bytes.take<std::uint8_t>();
    const bool wild = choice % 8 == 7;
    glm::dvec4 eye{0.0, 0.0, 0.0, 1.0};
    for (int axis = 0; axis < 3; ++axis) {
        eye[axis] = bytes.take<std::int8_t>() / 50.0 + 0.001; // within the cube or around it
    }
    const std::vector<WindowPolygon> triangles = take_triangles(bytes, wild);
    check_window_orders(triangles, wild);
    check_world_orders(in_world(triangles, wild), eye, choice, wild);
    return 0;
}
