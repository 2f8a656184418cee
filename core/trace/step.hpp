// Steps: the addressable moments of a frame.
//
// A step has a flat number (0 is `start`, the cleared framebuffer; the last is `end`) and a path
// people can write: `object 0 / triangle 12 / fragment 31,17 / depth test`. The state shown at a
// step is the state *after* it.
#pragma once

#include "core/base/named.hpp"
#include "core/base/pixel.hpp"
#include "core/geometry/clip_volume.hpp"
#include "core/scene/mesh.hpp"
#include "core/visibility/order_names.hpp"
#include "core/visibility/sweep_trace.hpp"

#include <cstdint>
#include <string>

namespace hs::trace {

using StepId = std::uint64_t;

enum class StepKind : std::uint8_t {
    start,
    vertex_world,
    vertex_eye,
    vertex_clip,
    vertex_light,
    order,
    sweep,
    outcodes,
    clip_plane,
    divide,
    viewport,
    facing,
    setup,
    edge_table,
    tile_test,
    active_edges,
    span,
    edge_test,
    sample_test,
    plane_test,
    line_step,
    interpolate,
    shade,
    scissor_test,
    closed_test,
    depth_test,
    merge,
    resolve,
    end,
};

/// The rooms of the pipeline, as the strip shows them.
enum class Stage : std::uint8_t {
    application,
    vertex,
    visibility,
    clip,
    divide,
    viewport,
    cull,
    setup,
    traverse,
    shade,
    test,
    merge,
};
inline constexpr int stage_count = 12;

Stage stage_of(StepKind kind);

/// How far one press of a key goes, from coarse to fine. A coarse step ends on the last step of its
/// unit.
enum class Granularity : std::uint8_t {
    stage,
    object,
    triangle,
    scanline,
    fragment,
    operation
};

/// Where a step stands. Fields that a kind has no use for keep their defaults.
struct Step {
    StepId id = 0;
    StepKind kind = StepKind::start;
    std::uint32_t object = 0;
    std::uint32_t vertex = 0; ///< vertex kinds: index into the object's mesh
    visibility::OrderEventKind decision = visibility::OrderEventKind::compare; ///< order
    std::uint32_t event = 0; ///< order: index into the recording's decisions
    visibility::SweepEventKind sweep = visibility::SweepEventKind::active_edges; ///< sweep
    std::uint32_t ordinal = 0; ///< order: how many of its kind came before; sweep: in its scanline
    bool of_polygon = false;   ///< sweep: about one triangle, or about two of which it is the first
    std::uint32_t triangle = 0; ///< outcodes and later: index into the object's primitives
    scene::PrimitiveKind primitive = scene::PrimitiveKind::triangle;
    std::uint32_t number = 0; ///< of lines and points: among the object's lines or points
    bool part = false;      ///< outcodes and later: of a part of a triangle that ordering has split
    bool clipped = false;   ///< the triangle was clipped, so that its piece is part of the path
    std::int32_t piece = 0; ///< divide and later; of a part already before
    std::int32_t unit = 0;  ///< tile test and later: unit of the traversal
    geometry::ClipPlane plane = geometry::ClipPlane::near; ///< clip_plane
    PixelPos pixel{}; ///< edge test and later, resolve; of a tile its first pixel, of a scanline
                      ///< its row; sweep: of a ray or a line of depths, else the row
    std::int32_t tile_size = 0; ///< tile_test: pixels a side
    std::int32_t sample = -1;   ///< of a pixel with several: sample test, its depth test, all of a
                                ///< fragment that stands for one sample, and of scan conversion
                                ///< whose scanline runs through it; else −1
    bool covered = false;       ///< edge, sample and plane test: inside; fragment kinds: true
    bool passed = true;         ///< tests: the verdict
    bool fatal = false;         ///< tests: the fragment ended here
    std::uint32_t fragment = 0; ///< interpolate and later: index into the fragment log

    [[nodiscard]] bool in_vertex_stage() const {
        return kind >= StepKind::vertex_world && kind <= StepKind::vertex_light;
    }
    [[nodiscard]] bool in_triangle() const {
        return kind >= StepKind::outcodes && kind <= StepKind::merge;
    }
    /// A decision about a pixel, not about a whole scanline.
    [[nodiscard]] bool sweeps_pixel() const {
        using visibility::SweepEventKind;
        return kind == StepKind::sweep &&
               (sweep == SweepEventKind::depth || sweep >= SweepEventKind::cast);
    }
    [[nodiscard]] bool has_piece() const {
        return in_triangle() && (part || kind >= StepKind::divide);
    }
    /// The same, and what is drawn is a triangle indeed, not a line or a point.
    [[nodiscard]] bool of_triangle() const {
        return in_triangle() && primitive == scene::PrimitiveKind::triangle;
    }
    /// Belongs to a unit of a traversal.
    [[nodiscard]] bool in_unit() const {
        return kind >= StepKind::tile_test && kind <= StepKind::merge;
    }
    [[nodiscard]] bool of_scanline() const {
        return kind == StepKind::active_edges || kind == StepKind::span;
    }
    [[nodiscard]] bool has_pixel() const {
        return kind >= StepKind::edge_test && kind <= StepKind::merge;
    }
    [[nodiscard]] bool in_fragment() const {
        return kind >= StepKind::interpolate && kind <= StepKind::merge;
    }
    friend bool operator==(const Step&, const Step&) = default;
};

/// "triangle 12", "line 2", "point 0". Precondition: step.in_triangle().
std::string primitive_name(const Step& step);

/// The path of a step, complete down to the operation.
std::string step_path(const Step& step);

} // namespace hs::trace

namespace hs {
template <>
std::span<const Named<trace::StepKind>> names<trace::StepKind>();
template <>
std::span<const Named<trace::Stage>> names<trace::Stage>();
template <>
std::span<const Named<trace::Granularity>> names<trace::Granularity>();
} // namespace hs
