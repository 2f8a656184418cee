// The reasoning behind a step: everything the pipeline computed for one vertex, triangle, pixel or
// fragment, obtained by running that primitive again with a sink that keeps the values.
#pragma once

#include "core/geometry/eye_facing.hpp"
#include "core/pipeline/narration.hpp"
#include "core/trace/recording.hpp"
#include "core/trace/sample_detail.hpp"

#include <array>
#include <optional>
#include <vector>

namespace hs::trace {

/// A point that was lit, and what each light adds to it.
struct LitPoint {
    shading::SurfacePoint surface;
    std::vector<shading::LightShare> lights;
};

struct VertexDetail {
    std::uint32_t object = 0;
    std::uint32_t vertex = 0;
    pipeline::Transforms transforms;
    pipeline::VertexWork work;
    geometry::Outcode outcode = 0;
    geometry::WindowVertex window; ///< meaningful when status is `placed`
    std::optional<LitPoint> lit;   ///< per-vertex lighting only
};

/// One plane's pass over the polygon.
struct ClipPass {
    geometry::ClipPlane plane = geometry::ClipPlane::near;
    geometry::ClipPolygon before;
    geometry::ClipPolygon after;
};

/// One piece of a triangle after clipping.
struct PieceDetail {
    std::array<geometry::WindowVertex, 3> window{};
    std::int64_t signed_doubled_area = 0; ///< in 1/65536 pixel², > 0: counterclockwise as seen
    geometry::TriangleVerdict facing = geometry::TriangleVerdict::drawn;
    std::optional<raster::TriangleSetup> setup; ///< empty: culled, degenerate or without a place
    std::optional<raster::HomogeneousSetup> planes; ///< homogeneous rasterization
    std::optional<double> determinant;              ///< its facing, if a vertex has no place
    std::optional<raster::LineSetup> line;          ///< lines and points
};

struct TriangleDetail {
    std::uint32_t object = 0;
    std::uint32_t triangle = 0; ///< of the object
    scene::Primitive primitive; ///< a triangle, or the line or point that counts as one
    scene::TriangleIndices vertices;
    std::array<VertexDetail, 3> corners;
    geometry::EyeFacing
        eye_facing; ///< facing as lectures teach it, beside each piece's signed area
    std::array<geometry::Outcode, 3> outcodes{};
    std::vector<ClipPass> passes; ///< empty: trivially accepted or rejected
    std::vector<PieceDetail> pieces;
    geometry::TriangleVerdict verdict = geometry::TriangleVerdict::drawn;
};

/// A pixel's edge test.
struct VisitDetail {
    PixelPos pixel;
    raster::EdgeValues edges{}; ///< E01, E12, E20 in 1/65536 pixel²
    bool inside = false;
};

/// What a traversal knew at a step: the last it worked out before, or at, the step.
struct TraversalDetail {
    std::optional<raster::TileTest> tile;        ///< the smallest that holds the step
    std::optional<raster::EdgeTable> edge_table; ///< of the whole piece
    std::optional<raster::ActiveEdges> active;   ///< on the step's scanline
    std::optional<raster::Span> span;            ///< likewise
    std::optional<raster::PlaneTest> planes;     ///< of the step's pixel
    std::optional<raster::LineStep> line;        ///< likewise
};

/// A fragment's life. Parts it did not reach are empty.
struct FragmentDetail {
    std::uint32_t index = no_fragment;    ///< into the fragment log
    std::uint32_t triangle = no_triangle; ///< over the whole frame
    raster::Fragment fragment;
    raster::EdgeValues edges{}; ///< where it is interpolated: its pixel's center, or its one sample
    std::optional<shading::ShadedFragment> shaded;
    std::optional<LitPoint> lit; ///< per-fragment lighting only
    std::optional<bool> scissor_inside;
    std::optional<bool> pixel_open;
    std::optional<pipeline::DepthTest> depth_test;
    std::optional<pipeline::Merge> merge; ///< with several samples, of what they resolve to
    fragment::FragmentFate fate = fragment::FragmentFate::written;
};

/// What a pixel with several samples becomes.
struct ResolveDetail {
    framebuffer::PixelSamples samples;
    framebuffer::SampleValue resolved;
};

/// What stands behind one step; the parts that its kind has.
struct StepDetail {
    std::optional<VertexDetail> vertex;
    std::optional<TriangleDetail> triangle;
    std::optional<TraversalDetail> traversal; ///< steps in a traversal
    std::optional<VisitDetail> visit;
    std::optional<FragmentDetail> fragment;
    std::optional<ResolveDetail> resolve;
    std::vector<SampleDetail> samples; ///< of the step's pixel, where there are several
};

/// Precondition: the numbers exist in the recording.
VertexDetail vertex_detail(const Recording& recording, std::uint32_t object, std::uint32_t vertex);
TriangleDetail
triangle_detail(const Recording& recording, std::uint32_t object, std::uint32_t triangle);
FragmentDetail fragment_detail(const Recording& recording, std::uint32_t fragment);
StepDetail step_detail(const Recording& recording, const Step& step);

/// A pixel just before a fragment reached it: a fold over the earlier fragments of that pixel.
struct PixelBefore {
    glm::vec4 color{0.0F};
    float depth = 0.0F;
    std::uint32_t triangle = no_triangle; ///< who owned it, over the whole frame
};
PixelBefore pixel_before(const Recording& recording, std::uint32_t fragment);

} // namespace hs::trace
