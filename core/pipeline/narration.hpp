// What the pipeline says while it runs. Every call marked *step* is one moment a playhead can stand
// on; the others only structure the story. A sink listens and never steers: deleting every `trace.`
// line must leave a correct program, and a test compares the framebuffers of all sinks.
#pragma once

#include "core/base/pixel.hpp"
#include "core/fragment/fate.hpp"
#include "core/framebuffer/samples.hpp"
#include "core/geometry/clip_polygon.hpp"
#include "core/geometry/facing.hpp"
#include "core/geometry/viewport.hpp"
#include "core/pipeline/vertex_stage.hpp"
#include "core/raster/homogeneous.hpp"
#include "core/raster/interpolation.hpp"
#include "core/raster/sample_pattern.hpp"
#include "core/raster/traversal.hpp"
#include "core/shading/shade.hpp"
#include "core/visibility/order_trace.hpp"
#include "core/visibility/sweep_trace.hpp"

#include <array>
#include <concepts>
#include <cstdint>

namespace hs::pipeline {

/// The depth test's numbers: `passed` is compare(op, depth, stored).
struct DepthTest {
    float depth = 0.0F;  ///< the fragment's, as its format stores it
    float stored = 0.0F; ///< the buffer's, before
    scene::CompareOp op = scene::CompareOp::less;
    bool passed = false;
    int sample = -1;       ///< whose, with several samples a pixel
    bool discards = false; ///< with several samples: this one failed as all before, and none follow
    /// The fragment ends here.
    [[nodiscard]] bool fatal() const { return sample < 0 ? !passed : discards; }
};

/// Which samples of its pixel a fragment stands for, where there are several.
struct FragmentSamples {
    raster::CoverageMask covered = 0;
    int sample = -1; ///< the one it is shaded at; −1: the pixel's center
    float first_depth =
        0.0F; ///< at the pixel's first sample, covered or not, as its format stores it
};

/// What merging changed.
struct Merge {
    glm::vec4 source{0.0F};
    glm::vec4 before{0.0F}; ///< read only where blending needs it, else 0
    bool blended = false;
    glm::vec4 after{0.0F}; ///< before the color format rounds it
    bool depth_written = false;
    float depth = 0.0F;
};

/// What merging changed in a pixel with several samples.
struct SamplesMerge {
    glm::vec4 source{0.0F};
    bool blended = false;
    bool depth_written = false;
    raster::CoverageMask written = 0; ///< samples that passed every test
    framebuffer::PixelSamples before;
    framebuffer::PixelSamples after; ///< before the color format rounds them
};

/// A triangle of the frame, or a piece of one.
struct PieceName {
    std::uint32_t object = 0;
    std::uint32_t triangle = 0; ///< of the object
    std::int32_t piece = 0;
    bool clipped = false; ///< there may be others
    friend bool operator==(const PieceName&, const PieceName&) = default;
};

template <typename T>
concept TraceSink = raster::TraversalTrace<T> && requires(
    T t,
    const T& ct,
    std::uint32_t id,
    int number,
    const std::array<geometry::Outcode, 3>& codes,
    const geometry::ClipPolygon& polygon,
    const std::array<geometry::WindowVertex, 3>& window,
    std::int64_t area,
    geometry::TriangleVerdict verdict,
    const raster::TriangleSetup& setup,
    const raster::HomogeneousSetup& planes,
    const raster::LineSetup& line,
    const raster::Fragment& fragment,
    const shading::ShadedFragment& shaded,
    const DepthTest& depth,
    const Merge& merge,
    const FragmentSamples& sampled,
    const SamplesMerge& samples_merge,
    const framebuffer::PixelSamples& samples,
    const PieceName& piece,
    fragment::FragmentFate fate
) {
    t.vertex_run(id, id, number); // *step* × number: world, eye, clip, and light for Gouraud
    // Here the ordering of triangles speaks, if there is one: visibility::OrderSink
    t.triangle_begin(id, id);
    t.part_begin(number); // only for parts of a triangle that was split: the first piece's number
    t.outcodes(codes);    // *step*
    t.clipped(geometry::ClipPlane::near, polygon, polygon); // *step*, per plane that clips
    t.piece_begin(number);
    t.divided(window);        // *step*
    t.mapped(window);         // *step*
    t.faced(area, verdict);   // *step*
    t.set_up(setup);          // *step*
    t.oriented(0.0, verdict); // *step*: homogeneous, across the eye, instead of the three above
    t.planes_set_up(planes);  // *step*: homogeneous, instead of set_up
    t.line_set_up(line);      // *step*: lines and points, instead of faced and set_up
    // Here the traversal speaks: raster::TraversalTrace
    t.sweep_begin(number);     // a row of the image, where whole rows are decided at once
    t.pixel_begin(PixelPos{}); // a ray of that row
    // Here scanlines and rays speak: visibility::SweepSink
    t.shown(piece);                  // what the fragments that follow are made of
    t.fragment_sampled(sampled);     // with several samples, before each fragment
    t.interpolated(fragment);        // *step*
    t.shaded(shaded);                // *step*
    t.scissor_tested(true);          // *step*, only with a scissor rectangle
    t.closed_tested(true);           // *step*, only where triangles come front to back
    t.depth_tested(depth);           // *step*, only with z-buffer visibility
    t.merged(merge);                 // *step*, only if every test passed
    t.samples_merged(samples_merge); // *step*, instead of merged
    t.fragment_end(fate);
    t.triangle_end(verdict, geometry::Outcode{});
    t.resolved(PixelPos{}, samples, samples[0]); // *step*, with several samples, per pixel
};

/// A sink that keeps no values of what it is told, only that it happened: what only its numbers
/// need may be left out.
template <typename T>
concept IgnoresValues = TraceSink<T> && T::ignores_values;

/// The sink that compiles away.
struct NullTrace : raster::SilentTraversal, visibility::SilentOrder, visibility::SilentSweep {
    static constexpr bool ignores_values = true;
    static constexpr bool ignores_traversal = true;

    void vertex_run(std::uint32_t, std::uint32_t, int) {}
    void triangle_begin(std::uint32_t, std::uint32_t) {}
    void part_begin(int) {}
    void outcodes(const std::array<geometry::Outcode, 3>&) {}
    void clipped(geometry::ClipPlane, const geometry::ClipPolygon&, const geometry::ClipPolygon&) {}
    void piece_begin(int) {}
    void divided(const std::array<geometry::WindowVertex, 3>&) {}
    void mapped(const std::array<geometry::WindowVertex, 3>&) {}
    void faced(std::int64_t, geometry::TriangleVerdict) {}
    void set_up(const raster::TriangleSetup&) {}
    void edge_tests(int) {}
    void oriented(double, geometry::TriangleVerdict) {}
    void planes_set_up(const raster::HomogeneousSetup&) {}
    void line_set_up(const raster::LineSetup&) {}
    void sweep_begin(int) {}
    void pixel_begin(PixelPos) {}
    void shown(const PieceName&) {}
    void fragment_sampled(const FragmentSamples&) {}
    void interpolated(const raster::Fragment&) {}
    void shaded(const shading::ShadedFragment&) {}
    void scissor_tested(bool) {}
    void closed_tested(bool) {}
    void depth_tested(const DepthTest&) {}
    void merged(const Merge&) {}
    void samples_merged(const SamplesMerge&) {}
    void fragment_end(fragment::FragmentFate) {}
    void triangle_end(geometry::TriangleVerdict, geometry::Outcode) {}
    void resolved(PixelPos, const framebuffer::PixelSamples&, const framebuffer::SampleValue&) {}
};
static_assert(TraceSink<NullTrace>);

} // namespace hs::pipeline
