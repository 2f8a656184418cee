#include "core/pipeline/order_refusal.hpp"

#include "core/pipeline/order.hpp"
#include "core/pipeline/sweep.hpp"

#include <fmt/format.h>

namespace hs::pipeline {
namespace {

/// Decisions that the algorithm will make, roughly.
double estimate(const Frame& frame) {
    using scene::Visibility;
    switch (frame.settings().visibility) {
    case Visibility::front_lists:
        return visibility::estimate_front_lists(window_polygons(frame).polygons.size());
    case Visibility::newell_sancha:
        return visibility::estimate_depth_sort(window_polygons(frame).polygons);
    case Visibility::bsp:
        return visibility::estimate_bsp(world_polygons(frame), bsp_options(frame.settings()));
    case Visibility::scanline:
    case Visibility::scanline_z:
    case Visibility::ray_cast: return estimate_sweep(frame);
    case Visibility::none:
    case Visibility::z_buffer:
    case Visibility::painters:
    case Visibility::octree: return 0.0; // n log n, or limited by themselves
    }
    HS_CHECK(false, "every algorithm has a cost");
    return 0.0;
}

bool is_in_world(scene::Visibility visibility) {
    using scene::Visibility;
    return visibility == Visibility::bsp || visibility == Visibility::octree ||
           visibility == Visibility::ray_cast;
}

/// Lines and points have no place among ordered triangles, and one sample a pixel.
std::optional<std::string> complaint_about_lines(const Frame& frame) {
    const scene::Settings& settings = frame.settings();
    for (const DrawCall& call : frame.calls()) {
        if (call.primitive_count() == call.triangles().size()) {
            continue;
        }
        if (settings.orders_triangles() || settings.sweeps()) {
            return fmt::format(
                "visibility \"{}\" {} triangles; object {} has lines or points, which need "
                "\"z-buffer\" or \"none\"",
                name_of(settings.visibility),
                settings.sweeps() ? "shows only" : "orders",
                call.object
            );
        }
        if (settings.samples > 1) {
            return fmt::format(
                "samples must be 1 here: object {} has lines or points, which are drawn with one "
                "sample a pixel",
                call.object
            );
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<std::string> refuse_order(const Frame& frame) {
    const scene::Settings& settings = frame.settings();
    if (auto complaint = complaint_about_lines(frame)) {
        return complaint;
    }
    if (is_in_world(settings.visibility)) {
        if (auto complaint = complaint_about_world(frame)) {
            return complaint;
        }
    }
    const double decisions = estimate(frame);
    if (decisions > settings.order_limit) {
        return fmt::format(
            "visibility \"{}\" would take about {:.1e} decisions on this scene; to let it, set "
            "order.limit higher than that",
            name_of(settings.visibility),
            decisions
        );
    }
    return std::nullopt;
}

} // namespace hs::pipeline
