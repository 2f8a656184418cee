// A recording: the facts of one frame, and what is needed to reach any moment of it quickly.
//
// Facts are recorded, reasoning is re-derived (re_run.hpp). Bounded memory: the fragment log has 20
// bytes per fragment; the step index has an entry per 2048 steps or per unit, whichever is coarser;
// checkpoints of the framebuffer keep to a budget, doubling their spacing when they reach it (after
// Box2D's recorder, src/recording_replay.c).
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/base/parallel.hpp"
#include "core/fragment/fate.hpp"
#include "core/geometry/facing.hpp"
#include "core/pipeline/draw_order.hpp"
#include "core/pipeline/frame.hpp"
#include "core/raster/cost.hpp"
#include "core/raster/sample_pattern.hpp"
#include "core/trace/chunked.hpp"
#include "core/trace/order_log.hpp"
#include "core/trace/pixel_buffer.hpp"
#include "core/trace/sample_log.hpp"
#include "core/trace/step.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace hs::trace {

/// One fragment, in execution order.
struct FragmentRecord {
    std::uint16_t x = 0;
    std::uint16_t y = 0;
    float depth = 0.0F; ///< as tested: clamped and rounded to the depth format; with several
                        ///< samples at the first one, covered or not
    framebuffer::Rgba8 color = 0; ///< the pixel's color *after* the fragment (rgba8; else see
                                  ///< color32f); with several samples what they would resolve to
    std::uint32_t previous =
        no_fragment; ///< the fragment that reached the same pixel before, whatever its fate
    fragment::FragmentFate fate = fragment::FragmentFate::written;
    bool depth_written = false;        ///< with several samples: that of the first one
    raster::CoverageMask coverage = 0; ///< with several samples: those it covers
    raster::CoverageMask passed = 0;   ///< of those, the ones that passed every test

    [[nodiscard]] PixelPos pixel() const { return {x, y}; }
    [[nodiscard]] bool written() const { return fate == fragment::FragmentFate::written; }
};
static_assert(sizeof(FragmentRecord) == 20);

/// A stretch of the fragment log made by one piece of one triangle.
struct Run {
    std::uint32_t first_fragment = 0;
    std::uint32_t triangle = 0; ///< over the whole frame, in file order
    std::uint16_t piece = 0;
};

/// How many decisions of scanlines or rays, of each kind.
using SweepCounts = std::array<std::uint64_t, visibility::sweep_event_kind_count>;

/// What has happened up to a step.
struct Counters {
    std::uint64_t vertices = 0;      ///< through the vertex stage
    OrderCounts decisions{};         ///< of the ordering algorithm, by kind
    SweepCounts sweeps{};            ///< decisions of scanlines and rays, by kind
    std::uint64_t triangles = 0;     ///< that entered clipping, or parts of split ones
    std::uint64_t clipped = 0;       ///< of those, crossing at least one plane
    std::uint64_t pieces = 0;        ///< triangles after clipping, divided
    std::uint64_t pieces_mapped = 0; ///< that reached the window
    std::uint64_t pieces_faced = 0;  ///< whose area was computed
    std::uint64_t pieces_set_up = 0; ///< that survived culling
    std::uint64_t scan_steps = 0;    ///< edge tables, their updates, spans
    raster::Cost traversal;          ///< pixels and tiles visited, and what that took
    std::uint64_t fragments = 0;     ///< covered pixels
    std::uint64_t fragments_shaded = 0;
    std::uint64_t fragments_tested = 0;                      ///< entered the tests
    std::array<std::uint64_t, fragment::fate_count> fates{}; ///< by FragmentFate
    friend bool operator==(const Counters&, const Counters&) = default;
};

/// A place to start a re-run from: the beginning of a draw, or of a unit inside one.
struct IndexEntry {
    StepId step = 0;            ///< the first step of what follows
    std::uint32_t fragment = 0; ///< the first fragment of what follows
    std::uint32_t draw = 0;     ///< index into the order of draws
    std::int32_t piece = 0;
    std::int32_t unit = -1; ///< −1: the draw's beginning
    Counters before;
};

/// The framebuffer after the first `fragments` fragments.
struct Checkpoint {
    std::uint32_t fragments = 0;
    PixelBuffer buffer;
};

/// One object's place in the frame-wide tables.
struct ObjectRange {
    std::uint32_t first_vertex = 0;
    std::uint32_t vertex_count = 0;
    std::uint32_t first_triangle = 0;
    std::uint32_t triangle_count = 0; ///< with lines and points, in that order behind them
    StepId first_vertex_step = 0;     ///< of its vertex stage
    int steps_per_vertex = 3;
    std::uint32_t last_draw = 0; ///< after it the object is finished; meaningless without triangles
};

struct TriangleRecord {
    StepId first_step = 0; ///< its outcodes; of a split triangle those of the part drawn first
    std::uint32_t last_draw = 0; ///< index into the order of draws
    geometry::TriangleVerdict verdict = geometry::TriangleVerdict::drawn;
    geometry::Outcode crossed = 0; ///< planes some vertex is outside of
};

/// Filled by `record`, constant afterwards.
struct Recording {
    std::shared_ptr<pipeline::Frame> frame; ///< with shaded vertices
    std::vector<ObjectRange> objects;
    std::vector<TriangleRecord> triangles; ///< over the whole frame, in file order
    OrderLog decisions;                    ///< of the ordering algorithm, if there is one
    pipeline::DrawOrder order;             ///< what is drawn when
    std::vector<StepId> draw_steps;        ///< the first step of each draw
    Chunked<FragmentRecord> fragments;
    Chunked<glm::vec4> color32f; ///< per fragment, rgba32f frames only
    SampleLog samples;           ///< per fragment, frames with several samples a pixel only
    std::vector<Run> runs;
    std::vector<IndexEntry>
        index; ///< by step; the first entry is the first triangle's beginning, if there is one
    std::vector<Checkpoint>
        checkpoints; ///< by fragments; the cleared framebuffer is not kept, it is made
    PixelBuffer final_pixels;
    Counters counters;              ///< of the whole frame
    StepId first_order_step = 0;    ///< the step after the vertex stage
    StepId first_triangle_step = 0; ///< the step after the ordering, which may have none
    StepId first_sweep_step = 0;    ///< the step after the last triangle's: of a row, or as below
    StepId first_resolve_step = 0;  ///< the step after the last row's: a resolve, or `end`
    StepId end_step = 0;            ///< the number of the last step, `end`
    double seconds = 0.0;           ///< how long recording took, for the introspection panel

    [[nodiscard]] const scene::Scene& scene() const { return frame->scene(); }
    [[nodiscard]] const scene::Settings& settings() const { return frame->settings(); }
    /// Colors are kept in color32f; a fragment's 8-bit color is then only for display.
    [[nodiscard]] bool float_color() const {
        return settings().color_format == scene::ColorFormat::rgba32f;
    }
    [[nodiscard]] int width() const { return settings().width; }
    [[nodiscard]] int height() const { return settings().height; }
    /// Frame-wide triangle number to object and its own number. Precondition: in range.
    [[nodiscard]] std::uint32_t object_of_triangle(std::uint32_t triangle) const;
    [[nodiscard]] std::uint32_t triangle_of_draw(const pipeline::Draw& draw) const {
        return objects[draw.object].first_triangle + draw.triangle;
    }
    /// All draws of a triangle, in execution order: one, or one per part.
    [[nodiscard]] std::vector<std::uint32_t> draws_of_triangle(std::uint32_t triangle) const;
    /// The draw a step of the triangle stages belongs to.
    [[nodiscard]] std::uint32_t draw_of_step(StepId step) const;
    /// The first draw that is a row of the image; as many as there are draws if none is.
    [[nodiscard]] std::uint32_t first_row_draw() const;
    /// Precondition: the row is drawn as a whole.
    [[nodiscard]] std::uint32_t draw_of_row(int row) const {
        const std::uint32_t first = first_row_draw();
        return first + static_cast<std::uint32_t>(row - order.draws[first].row);
    }
    /// Whether a step belongs to a row of the image that is drawn as a whole.
    [[nodiscard]] bool in_row(StepId step) const {
        return step >= first_sweep_step && step < first_resolve_step;
    }
    /// The run a fragment belongs to.
    [[nodiscard]] const Run& run_of_fragment(std::uint32_t fragment) const;
    /// What the facts take in memory, without scene and shaded vertices.
    [[nodiscard]] std::size_t bytes() const;
    /// Color and depth bits of the final image; equals Framebuffer::digest() of the untraced frame.
    [[nodiscard]] std::uint64_t digest() const;
};

/// "object 0 / triangle 12", "object 0 / line 2". `triangle` counts within the object.
std::string
primitive_path(const Recording& recording, std::uint32_t object, std::uint32_t triangle);

struct RecordOptions {
    std::size_t checkpoint_budget = std::size_t{512} << 20U; ///< bytes
    std::uint32_t checkpoint_spacing = 1U << 20U; ///< fragments between checkpoints, at first
    unsigned threads = hardware_threads();        ///< for the vertex stage
    /// Called now and then with the part done in [0, 1]; returning false stops. May be empty.
    std::function<bool(double)> progress{};
};

/// Runs the pipeline over the scene and keeps its facts. Errors: stopped by `progress`; more
/// fragments than can be numbered; out of memory.
Result<std::shared_ptr<const Recording>>
record(std::shared_ptr<const scene::Scene> scene, const RecordOptions& options = {});

} // namespace hs::trace
