#include "core/pipeline/fault.hpp"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace hs::pipeline {
namespace {

using scene::CompareOp;
using scene::Fault;

CompareOp inverted(CompareOp op) {
    switch (op) {
    case CompareOp::never: return CompareOp::always;
    case CompareOp::less: return CompareOp::gequal;
    case CompareOp::lequal: return CompareOp::greater;
    case CompareOp::equal: return CompareOp::notequal;
    case CompareOp::gequal: return CompareOp::less;
    case CompareOp::greater: return CompareOp::lequal;
    case CompareOp::notequal: return CompareOp::equal;
    case CompareOp::always: return CompareOp::never;
    }
    HS_CHECK(false, "every compare op is handled");
    return op;
}

} // namespace

void seed_fault(DrawCall& call) {
    scene::Settings& settings = call.settings;
    Transforms& transforms = call.vertex.transforms;
    switch (settings.fault) {
    case Fault::half_up_rounding: call.viewport.snapping = geometry::Snapping::half_up; break;
    case Fault::floor_snapping: call.viewport.snapping = geometry::Snapping::floor; break;
    case Fault::no_divide: call.viewport.divides = false; break;
    case Fault::viewport_without_parentheses: // (1 − y/2)·H instead of (1 − y)/2·H
        call.viewport.center_y += call.viewport.half_height;
        break;
    case Fault::near_plane_forgotten: // everything is inside of 0 >= 0
        call.volume.planes[static_cast<std::size_t>(geometry::ClipPlane::near)] = {};
        break;
    case Fault::reversed_winding:
        settings.front_face =
            settings.front_face == scene::Winding::ccw ? scene::Winding::cw : scene::Winding::ccw;
        break;
    case Fault::inverted_depth_test:
        settings.depth_test_choice = inverted(settings.depth_test());
        break;
    case Fault::affine_interpolation:
        if (settings.interpolation == scene::InterpolationKind::perspective) {
            settings.interpolation = scene::InterpolationKind::linear;
        }
        break;
    case Fault::camera_not_inverted:
        transforms.view.matrix = glm::inverse(transforms.view.matrix);
        break;
    case Fault::normals_like_points:
        transforms.normal = glm::mat3{transforms.view.matrix * transforms.model.matrix};
        break;
    case Fault::none:
    case Fault::ties_to_all:
    case Fault::ties_to_none:
    case Fault::ties_to_bottom_right:
    case Fault::increment_before_test: break; // of the setup
    }
}

void seed_fault(Fault fault, raster::TriangleSetup& setup) {
    for (unsigned k = 0; k < 3; ++k) {
        raster::EdgeFunction& edge = setup.edges[k];
        std::int64_t& bias = setup.top_left_bias[k];
        if (fault == Fault::ties_to_all) {
            bias = 0; // E >= 0 on every edge
        } else if (fault == Fault::ties_to_none) {
            bias = -1; // E > 0 on every edge
        } else if (fault == Fault::ties_to_bottom_right) {
            bias = edge.owns_ties() ? -1 : 0;
        } else if (fault == Fault::increment_before_test) {
            edge.c += edge.a * subpixel_scale; // every pixel gets its right neighbor's values
        }
    }
}

} // namespace hs::pipeline
