// The names of every choice a setting offers, each with the sentence that explains it.
#include "core/scene/mesh.hpp"
#include "core/scene/settings.hpp"

namespace hs {

namespace {

using namespace scene; // NOLINT(google-build-using-namespace): tables of that room's enumerations

constexpr Named<Visibility> visibility_names[] = {
    {Visibility::none,
     "none",
     "triangles are drawn in file order, the later one covers the earlier one"},
    {Visibility::z_buffer,
     "z-buffer",
     "every pixel remembers the depth of what it shows and keeps a fragment that passes the depth "
     "test"},
    {Visibility::painters,
     "painters",
     "triangles are sorted by one depth each and painted from the farthest to the nearest"},
    {Visibility::front_lists,
     "front-lists",
     "what nothing undrawn lies behind is drawn, by a list for every polygon of those in front"},
    {Visibility::newell_sancha,
     "newell-sancha",
     "sorted by the farthest depth, then five tests for every pair that overlaps; cycles are cut"},
    {Visibility::bsp,
     "bsp",
     "space is divided by the triangles' planes, once for all eyes, and walked from the eye"},
    {Visibility::octree,
     "octree",
     "space is divided in eighths, walked from the nearest; a written pixel is closed"},
    {Visibility::scanline,
     "scanline",
     "along each row of pixels the nearest is decided anew at every edge that is crossed"},
    {Visibility::scanline_z,
     "scanline-z",
     "row by row, all triangles are held against depths of one line of pixels"},
    {Visibility::ray_cast,
     "ray-cast",
     "a ray through every pixel is held against every triangle; the nearest hit is kept"},
};

constexpr Named<BspSplitter> bsp_splitter_names[] = {
    {BspSplitter::first, "first", "the first triangle of a list divides it"},
    {BspSplitter::random, "random", "any triangle of a list divides it, by a seed"},
    {BspSplitter::fewest_splits,
     "fewest-splits",
     "the triangle whose plane cuts the fewest others, of some that are asked, divides a list"},
};

constexpr Named<BspOrder> bsp_order_names[] = {
    {BspOrder::back_to_front, "back-to-front", "the nearer paints over the farther"},
    {BspOrder::front_to_back,
     "front-to-back",
     "the nearest is drawn first, and a written pixel is closed"},
};

constexpr Named<PaintersKey> painters_key_names[] = {
    {PaintersKey::farthest, "farthest", "a polygon stands where its farthest corner is"},
    {PaintersKey::nearest, "nearest", "a polygon stands where its nearest corner is"},
    {PaintersKey::centroid, "centroid", "a polygon stands at the average depth of its corners"},
};

constexpr Named<TraversalKind> traversal_names[] = {
    {TraversalKind::brute_force,
     "brute-force",
     "every pixel of the viewport is tested against the three edges of every triangle"},
    {TraversalKind::bounding_box,
     "bounding-box",
     "only the pixels of the triangle's bounding box are tested against its three edges"},
    {TraversalKind::incremental,
     "incremental",
     "the bounding box, each edge value reached from its neighbor's by one addition"},
    {TraversalKind::serpentine,
     "serpentine",
     "the bounding box in a zig-zag, so that every pixel is next to the one before"},
    {TraversalKind::hierarchical,
     "hierarchical",
     "tiles are rejected or accepted by their corners, others quartered and asked closer"},
    {TraversalKind::edge_walk,
     "edge-walk",
     "down the left and the right edge at once, filling the span between them"},
    {TraversalKind::edge_table,
     "edge-table",
     "edges in buckets, a table of active ones kept sorted from scanline to scanline"},
    {TraversalKind::homogeneous,
     "homogeneous",
     "pixels are held against the planes through eye and edges; nothing is clipped"},
};

constexpr Named<CullFace> cull_names[] = {
    {CullFace::none, "none", "both sides of every triangle are drawn"},
    {CullFace::back, "back", "triangles seen from behind are discarded"},
    {CullFace::front, "front", "triangles seen from the front are discarded"},
};

constexpr Named<Winding> winding_names[] = {
    {Winding::ccw,
     "ccw",
     "a triangle whose corners run counter-clockwise on screen shows its front"},
    {Winding::cw, "cw", "a triangle whose corners run clockwise on screen shows its front"},
};

constexpr Named<Shading> shading_names[] = {
    {Shading::unlit, "unlit", "vertex color times diffuse color times texel, no lights"},
    {Shading::flat, "flat", "one lighting computation per triangle, with its geometric normal"},
    {Shading::gouraud, "gouraud", "lighting is computed per vertex and its color interpolated"},
    {Shading::phong, "phong", "normals are interpolated and lighting is computed per fragment"},
};

constexpr Named<InterpolationKind> interpolation_names[] = {
    {InterpolationKind::perspective,
     "perspective",
     "varyings are divided by clip w, interpolated in the window and multiplied back: true in "
     "space"},
    {InterpolationKind::linear,
     "linear",
     "varyings are interpolated linearly in the window, which bends textures in perspective"},
    {InterpolationKind::flat,
     "flat",
     "every fragment takes the values of the provoking vertex, the last one"},
};

constexpr Named<CompareOp> compare_names[] = {
    {CompareOp::never, "never", "no fragment passes"},
    {CompareOp::less, "less", "a fragment passes when its depth is less than the stored depth"},
    {CompareOp::lequal,
     "lequal",
     "a fragment passes when its depth is less than or equal to the stored depth"},
    {CompareOp::equal, "equal", "a fragment passes when its depth equals the stored depth"},
    {CompareOp::gequal,
     "gequal",
     "a fragment passes when its depth is greater than or equal to the stored depth"},
    {CompareOp::greater,
     "greater",
     "a fragment passes when its depth is greater than the stored depth"},
    {CompareOp::notequal,
     "notequal",
     "a fragment passes when its depth differs from the stored depth"},
    {CompareOp::always, "always", "every fragment passes"},
};

constexpr Named<DepthFormat> depth_format_names[] = {
    {DepthFormat::float32, "float32", "32-bit floating point: finest near 0"},
    {DepthFormat::unorm24, "unorm24", "24-bit fixed point: 2^24 - 1 equal intervals over [0, 1]"},
    {DepthFormat::unorm16,
     "unorm16",
     "16-bit fixed point: 65535 equal intervals, so surfaces soon fight"},
};

constexpr Named<DepthConvention> depth_convention_names[] = {
    {DepthConvention::opengl,
     "opengl",
     "NDC z runs from -1 at the near plane to 1 at the far plane"},
    {DepthConvention::direct3d,
     "direct3d",
     "NDC z runs from 0 at the near plane to 1 at the far plane"},
    {DepthConvention::reversed,
     "reversed",
     "NDC z runs from 1 at the near plane to 0 at the far plane, where floats are finest"},
};

constexpr Named<DepthOrder> depth_order_names[] = {
    {DepthOrder::late, "late", "the depth test comes after shading, as the pipeline is defined"},
    {DepthOrder::early,
     "early",
     "the depth test comes before shading, so hidden fragments cost no shading"},
};

constexpr Named<LineAlgorithm> line_algorithm_names[] = {
    {LineAlgorithm::bresenham,
     "bresenham",
     "an error term in whole numbers decides whether the line moves across at each pixel"},
    {LineAlgorithm::dda, "dda", "the slope is added at each pixel, and the sum is rounded"},
};

constexpr Named<PrimitiveKind> primitive_names[] = {
    {PrimitiveKind::triangle, "triangle", "three vertices, and what lies between them"},
    {PrimitiveKind::line, "line", "two vertices, and a line of pixels from one to the other"},
    {PrimitiveKind::point, "point", "one vertex, and the pixel that holds it"},
};

constexpr Named<ColorFormat> color_format_names[] = {
    {ColorFormat::rgba8,
     "rgba8",
     "8 bits per channel: clamped to [0, 1], rounded to nearest, ties to even"},
    {ColorFormat::rgba32f, "rgba32f", "a 32-bit float per channel: neither clamped nor rounded"},
};

constexpr Named<Sampling> sampling_names[] = {
    {Sampling::multisample,
     "multisample",
     "coverage and depth per sample, one color for all of a pixel's samples"},
    {Sampling::supersample,
     "supersample",
     "every covered sample is interpolated, shaded and tested on its own"},
    {Sampling::conservative,
     "conservative",
     "a pixel counts when any part of its square lies inside the triangle"},
};

constexpr Named<Fault> fault_names[] = {
    {Fault::none, "none", "the pipeline as it should be"},
    {Fault::ties_to_all,
     "ties-to-all",
     "a pixel center on an edge belongs to both neighbors: all tests are E >= 0"},
    {Fault::ties_to_none,
     "ties-to-none",
     "a pixel center on an edge belongs to neither neighbor: all tests are E > 0"},
    {Fault::ties_to_bottom_right,
     "ties-to-bottom-right",
     "bottom and right edges own the pixel centers on them instead of top and left ones"},
    {Fault::half_up_rounding, "half-up-rounding", "snapping rounds halves up instead of to even"},
    {Fault::floor_snapping, "floor-snapping", "snapping rounds down instead of to nearest"},
    {Fault::increment_before_test,
     "increment-before-test",
     "edge values move on before the test, so every pixel asks for its right neighbor"},
    {Fault::affine_interpolation,
     "affine-interpolation",
     "varyings are interpolated linearly in the window although perspective is asked for"},
    {Fault::no_divide, "no-divide", "clip coordinates are taken for NDC without dividing by w"},
    {Fault::viewport_without_parentheses,
     "viewport-without-parentheses",
     "y = (1 - y_ndc/2) H instead of (1 - y_ndc)/2 H"},
    {Fault::near_plane_forgotten,
     "near-plane-forgotten",
     "triangles are clipped against every plane but the near one"},
    {Fault::reversed_winding, "reversed-winding", "fronts are taken for backs"},
    {Fault::inverted_depth_test,
     "inverted-depth-test",
     "a fragment passes the depth test where it should fail"},
    {Fault::normals_like_points,
     "normals-like-points",
     "normals go through the model matrix itself instead of its inverse transpose"},
    {Fault::camera_not_inverted,
     "camera-not-inverted",
     "vertices go through the camera-to-world matrix instead of its inverse"},
};

} // namespace

template <>
std::span<const Named<Visibility>> names<Visibility>() {
    return visibility_names;
}
template <>
std::span<const Named<PaintersKey>> names<PaintersKey>() {
    return painters_key_names;
}
template <>
std::span<const Named<BspSplitter>> names<BspSplitter>() {
    return bsp_splitter_names;
}
template <>
std::span<const Named<BspOrder>> names<BspOrder>() {
    return bsp_order_names;
}
template <>
std::span<const Named<TraversalKind>> names<TraversalKind>() {
    return traversal_names;
}
template <>
std::span<const Named<CullFace>> names<CullFace>() {
    return cull_names;
}
template <>
std::span<const Named<Winding>> names<Winding>() {
    return winding_names;
}
template <>
std::span<const Named<Shading>> names<Shading>() {
    return shading_names;
}
template <>
std::span<const Named<InterpolationKind>> names<InterpolationKind>() {
    return interpolation_names;
}
template <>
std::span<const Named<CompareOp>> names<CompareOp>() {
    return compare_names;
}
template <>
std::span<const Named<DepthFormat>> names<DepthFormat>() {
    return depth_format_names;
}
template <>
std::span<const Named<DepthConvention>> names<DepthConvention>() {
    return depth_convention_names;
}
template <>
std::span<const Named<DepthOrder>> names<DepthOrder>() {
    return depth_order_names;
}
template <>
std::span<const Named<LineAlgorithm>> names<LineAlgorithm>() {
    return line_algorithm_names;
}
template <>
std::span<const Named<PrimitiveKind>> names<PrimitiveKind>() {
    return primitive_names;
}
template <>
std::span<const Named<ColorFormat>> names<ColorFormat>() {
    return color_format_names;
}
template <>
std::span<const Named<Sampling>> names<Sampling>() {
    return sampling_names;
}
template <>
std::span<const Named<Fault>> names<Fault>() {
    return fault_names;
}

} // namespace hs
