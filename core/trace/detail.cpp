#include "core/trace/detail.hpp"

#include "core/base/check.hpp"
#include "core/pipeline/run_draw.hpp"
#include "core/trace/past_pixels.hpp"
#include "core/trace/player.hpp"

#include <algorithm>
#include <utility>

namespace hs::trace {
namespace {

/// Keeps the values of one triangle's geometry.
class TriangleTrace : public raster::SilentTraversal, public visibility::SilentSweep {
public:
    explicit TriangleTrace(TriangleDetail& triangle) : triangle_(triangle) {}

    void vertex_run(std::uint32_t, std::uint32_t, int) {}
    void triangle_begin(std::uint32_t, std::uint32_t) {}
    void part_begin(int) {}
    void outcodes(const std::array<geometry::Outcode, 3>& codes) { triangle_.outcodes = codes; }
    void clipped(
        geometry::ClipPlane plane,
        const geometry::ClipPolygon& before,
        const geometry::ClipPolygon& after
    ) {
        triangle_.passes.push_back({plane, before, after});
    }
    /// Pieces that clipping left none of are empty.
    void piece_begin(int piece) { triangle_.pieces.resize(static_cast<std::size_t>(piece) + 1); }
    void divided(const std::array<geometry::WindowVertex, 3>& window) {
        triangle_.pieces.back().window = window;
    }
    void mapped(const std::array<geometry::WindowVertex, 3>&) {}
    void faced(std::int64_t area, geometry::TriangleVerdict facing) {
        triangle_.pieces.back().signed_doubled_area = area;
        triangle_.pieces.back().facing = facing;
    }
    void set_up(const raster::TriangleSetup& setup) { triangle_.pieces.back().setup = setup; }
    void oriented(double determinant, geometry::TriangleVerdict facing) {
        triangle_.pieces.back().determinant = determinant;
        triangle_.pieces.back().facing = facing;
    }
    void planes_set_up(const raster::HomogeneousSetup& planes) {
        triangle_.pieces.back().planes = planes;
        triangle_.pieces.back().setup = planes.window;
    }
    void line_set_up(const raster::LineSetup& line) { triangle_.pieces.back().line = line; }
    void sweep_begin(int) {}
    void pixel_begin(PixelPos) {}
    void shown(const pipeline::PieceName&) {}
    void fragment_sampled(const pipeline::FragmentSamples&) {}
    void interpolated(const raster::Fragment&) {}
    void shaded(const shading::ShadedFragment&) {}
    void scissor_tested(bool) {}
    void closed_tested(bool) {}
    void depth_tested(const pipeline::DepthTest&) {}
    void merged(const pipeline::Merge&) {}
    void samples_merged(const pipeline::SamplesMerge&) {}
    void fragment_end(fragment::FragmentFate) {}
    void triangle_end(geometry::TriangleVerdict, geometry::Outcode) {}
    void resolved(PixelPos, const framebuffer::PixelSamples&, const framebuffer::SampleValue&) {}

private:
    TriangleDetail& triangle_;
};
static_assert(pipeline::TraceSink<TriangleTrace>);

/// Keeps also what the traversal knew at a step, and the values of the step's fragment.
class StepTrace : public TriangleTrace {
public:
    StepTrace(StepDetail& detail, const Step& step, scene::ColorFormat color_format)
        : TriangleTrace(*detail.triangle),
          traversal_(detail.traversal ? &*detail.traversal : nullptr),
          fragment_(detail.fragment ? &*detail.fragment : nullptr),
          step_(step),
          color_format_(color_format),
          reached_(!detail.traversal) {}

    void piece_begin(int piece) {
        TriangleTrace::piece_begin(piece);
        piece_ = piece;
    }
    void edge_test(PixelPos pixel, const raster::EdgeValues&, bool) {
        reached_ = reached_ || is_step(StepKind::edge_test, pixel);
    }
    void sample_tested(const raster::SampleTest& test) {
        reached_ =
            reached_ || (is_step(StepKind::sample_test, test.pixel) && test.sample == step_.sample);
    }
    void tile_tested(const raster::TileTest& tile) {
        if (!reached_) {
            traversal_->tile = tile;
            reached_ = is_step(StepKind::tile_test, tile.origin) && tile.size == step_.tile_size;
        }
    }
    void edges_bucketed(const raster::EdgeTable& table) {
        if (!reached_) {
            traversal_->edge_table = table;
            reached_ = step_.kind == StepKind::edge_table && piece_ == step_.piece &&
                       table.place.sample == step_.sample;
        }
    }
    void edges_activated(const raster::ActiveEdges& active) {
        if (!reached_) {
            traversal_->active = active;
            reached_ = is_step(StepKind::active_edges, {0, active.row}) &&
                       active.place.sample == step_.sample;
        }
    }
    void span_found(const raster::Span& span) {
        if (!reached_) {
            traversal_->span = span;
            reached_ = is_step(StepKind::span, {0, span.row}) && span.place.sample == step_.sample;
        }
    }
    void line_stepped(const raster::LineStep& line) {
        if (!reached_) {
            traversal_->line = line;
            reached_ = is_step(StepKind::line_step, line.pixel);
        }
    }
    void planes_tested(PixelPos pixel, const raster::PlaneTest& test) {
        if (!reached_) {
            traversal_->planes = test;
            reached_ = is_step(StepKind::plane_test, pixel);
        }
    }
    void fragment_sampled(const pipeline::FragmentSamples& sampled) { sample_ = sampled.sample; }
    void interpolated(const raster::Fragment& fragment) {
        listening_ = fragment_ != nullptr && fragment.pixel == step_.pixel &&
                     (sample_ < 0 || sample_ == step_.sample);
        if (listening_) {
            reached_ = true;
            fragment_->fragment = fragment;
        }
    }
    void shaded(const shading::ShadedFragment& shaded) {
        if (listening_) {
            fragment_->shaded = shaded;
        }
    }
    void scissor_tested(bool inside) {
        if (listening_) {
            fragment_->scissor_inside = inside;
        }
    }
    void closed_tested(bool open) {
        if (listening_) {
            fragment_->pixel_open = open;
        }
    }
    void depth_tested(const pipeline::DepthTest& test) {
        const bool later = step_.kind == StepKind::depth_test && fragment_->depth_test &&
                           test.sample > step_.sample;
        if (listening_ && !later) {
            fragment_->depth_test = test;
        }
    }
    void merged(const pipeline::Merge& merge) {
        if (listening_) {
            fragment_->merge = merge;
        }
    }
    void samples_merged(const pipeline::SamplesMerge& merge) {
        if (!listening_) {
            return;
        }
        const framebuffer::SampleValue after = framebuffer::resolve(merge.after, color_format_);
        fragment_->merge = pipeline::Merge{
            .source = merge.source,
            .before = framebuffer::resolve(merge.before, color_format_).color,
            .blended = merge.blended,
            .after = after.color,
            .depth_written = merge.depth_written && raster::has_sample(merge.written, 0),
            .depth = after.depth};
    }
    void fragment_end(fragment::FragmentFate fate) {
        if (listening_) {
            fragment_->fate = fate;
        }
    }

private:
    [[nodiscard]] bool is_step(StepKind kind, PixelPos place) const {
        return step_.kind == kind && step_.pixel == place;
    }

    TraversalDetail* traversal_;
    FragmentDetail* fragment_;
    const Step& step_;
    scene::ColorFormat color_format_;
    bool reached_; ///< what comes after the step is not kept
    int piece_ = 0;
    int sample_ = -1; ///< of a fragment that stands for one
    bool listening_ = false;
};
static_assert(pipeline::TraceSink<StepTrace>);

/// The part of a triangle's traversal that a step's pixel belongs to: one unit.
pipeline::TriangleScope scope_of(const Step& step) {
    return {step.piece, step.unit, step.piece, step.unit + 1};
}

constexpr pipeline::TriangleScope geometry_only{0, 0, 0, 0};

/// The row a step lies in; of rays, only its own.
pipeline::TriangleScope row_scope(const Recording& recording, const Step& step) {
    const bool rays = recording.settings().visibility == scene::Visibility::ray_cast;
    return rays ? pipeline::TriangleScope{0, step.unit, 0, step.unit + 1}
                : pipeline::TriangleScope{};
}

TriangleDetail
empty_triangle_detail(const Recording& recording, std::uint32_t object, std::uint32_t triangle) {
    const pipeline::DrawCall& call = recording.frame->calls()[object];
    TriangleDetail detail;
    detail.object = object;
    detail.triangle = triangle;
    detail.primitive = call.primitive(triangle);
    detail.vertices = detail.primitive.vertices;
    for (int corner = 0; corner < 3; ++corner) {
        detail.corners[static_cast<unsigned>(corner)] =
            vertex_detail(recording, object, detail.vertices[corner]);
    }
    detail.eye_facing = geometry::eye_facing(
        std::array{
            detail.corners[0].work.eye, detail.corners[1].work.eye, detail.corners[2].work.eye},
        call.settings.front_face,
        call.vertex.shading.orthographic,
        scene::forward_sign(recording.scene().camera)
    );
    detail.verdict =
        recording.triangles[recording.objects[object].first_triangle + triangle].verdict;
    return detail;
}

LitPoint light(const pipeline::DrawCall& call, const shading::SurfacePoint& surface) {
    return {surface, shading::light_shares(surface, call.vertex.shading.lights)};
}

/// The surface that per-fragment lighting met: what shading gives before it is lit.
LitPoint lit_fragment(const pipeline::DrawCall& call, const math::Varyings& varyings) {
    shading::ShadingInputs unlit = call.vertex.shading;
    unlit.shading = scene::Shading::unlit;
    const glm::vec4 color = shading::shade(unlit, varyings).color;
    return light(call, shading::surface_at(call.vertex.shading, varyings, color));
}

ResolveDetail resolve_detail(const Recording& recording, PixelPos pixel) {
    ResolveDetail detail;
    detail.samples = recording.samples.after(recording.final_pixels[pixel].last_fragment);
    detail.resolved = framebuffer::resolve(detail.samples, recording.settings().color_format);
    return detail;
}

/// Runs draws of one triangle up to setup; clipping and outcodes shown are those of the last.
void run_geometry(
    const Recording& recording,
    const std::vector<std::uint32_t>& draws,
    TriangleDetail& detail,
    TriangleTrace& trace
) {
    const std::uint32_t no_one = no_fragment;
    PastPixels pixels(recording, no_one);
    const pipeline::DrawOrder& order = recording.order;
    for (const std::uint32_t draw : draws) {
        detail.passes.clear();
        pipeline::run_draw(
            *recording.frame, order, order.draws[draw], geometry_only, pixels, trace
        );
    }
}

} // namespace

VertexDetail vertex_detail(const Recording& recording, std::uint32_t object, std::uint32_t vertex) {
    const pipeline::DrawCall& call = recording.frame->calls()[object];
    VertexDetail detail;
    detail.object = object;
    detail.vertex = vertex;
    detail.transforms = call.vertex.transforms;
    detail.work = pipeline::run_vertex(call.vertex, vertex);
    detail.outcode = geometry::outcode(call.volume, detail.work.clip);
    detail.window = geometry::to_window(detail.work.clip, call.viewport);
    if (detail.work.terms) {
        detail.lit = light(call, pipeline::vertex_surface(call.vertex, vertex, detail.work.eye));
    }
    return detail;
}

TriangleDetail
triangle_detail(const Recording& recording, std::uint32_t object, std::uint32_t triangle) {
    TriangleDetail detail = empty_triangle_detail(recording, object, triangle);
    const std::uint32_t frame_triangle = recording.objects[object].first_triangle + triangle;
    TriangleTrace trace(detail);
    run_geometry(recording, recording.draws_of_triangle(frame_triangle), detail, trace);
    return detail;
}

StepDetail step_detail(const Recording& recording, const Step& step) {
    StepDetail detail;
    if (step.in_vertex_stage()) {
        detail.vertex = vertex_detail(recording, step.object, step.vertex);
        return detail;
    }
    if (step.kind == StepKind::resolve) {
        detail.resolve = resolve_detail(recording, step.pixel);
    }
    if (!step.in_triangle()) {
        return detail;
    }

    // Run the triangle again: its geometry, and the one unit the step lies in
    detail.triangle = empty_triangle_detail(recording, step.object, step.triangle);
    if (step.in_fragment()) {
        detail.fragment.emplace();
        detail.fragment->index = step.fragment;
        detail.fragment->triangle = recording.objects[step.object].first_triangle + step.triangle;
    }
    const bool traverses = step.in_unit() && !recording.in_row(step.id);
    if (traverses || step.kind == StepKind::edge_table) {
        detail.traversal.emplace();
    }
    const std::uint32_t own = recording.draw_of_step(step.id);
    const std::vector<std::uint32_t> draws =
        recording.draws_of_triangle(recording.objects[step.object].first_triangle + step.triangle);
    const bool in_row = recording.in_row(step.id); // then its own draw is not the triangle's
    const auto position = in_row ? draws.end() : std::find(draws.begin(), draws.end(), own);
    TriangleTrace parts(*detail.triangle);
    run_geometry(recording, {draws.begin(), position}, *detail.triangle, parts);
    if (!in_row) {
        detail.triangle->passes.clear();
    }
    PastPixels pixels(recording, step.fragment);
    StepTrace trace(detail, step, recording.settings().color_format);
    pipeline::run_draw(
        *recording.frame,
        recording.order,
        recording.order.draws[own],
        in_row           ? row_scope(recording, step)
        : step.in_unit() ? scope_of(step)
                         : geometry_only,
        pixels,
        trace
    );
    if (!in_row) {
        TriangleDetail later = *detail.triangle;
        TriangleTrace later_parts(later);
        run_geometry(recording, {position + 1, draws.end()}, later, later_parts);
        detail.triangle->pieces = std::move(later.pieces);
    }

    if (detail.fragment && detail.fragment->shaded && detail.fragment->shaded->terms) {
        detail.fragment->lit =
            lit_fragment(recording.frame->calls()[step.object], detail.fragment->fragment.varyings);
    }

    // Ask the pixel's edge test again; across the eye there is none
    const auto& pieces = detail.triangle->pieces;
    const auto piece = static_cast<std::size_t>(step.piece);
    if (step.has_pixel() && pieces[piece].setup) {
        const raster::EdgeValues edges = pieces[piece].setup->evaluate(step.pixel);
        detail.visit = VisitDetail{step.pixel, edges, pieces[piece].setup->covers(edges)};
        if (recording.samples.active()) {
            detail.samples =
                samples_of_piece(recording, *pieces[piece].setup, pieces[piece].window, step);
        }
        if (detail.fragment) {
            const bool one = recording.settings().sampling == scene::Sampling::supersample;
            detail.fragment->edges =
                one ? detail.samples[static_cast<std::size_t>(step.sample)].edges : edges;
        }
    }
    return detail;
}

FragmentDetail fragment_detail(const Recording& recording, std::uint32_t fragment) {
    const Step step = describe_step(recording, last_step_of_fragment(recording, fragment));
    return *step_detail(recording, step).fragment;
}

PixelBefore pixel_before(const Recording& recording, std::uint32_t fragment) {
    const scene::Settings& settings = recording.settings();
    PixelBefore before;
    bool color_found = false;
    bool depth_found = false;
    std::uint32_t i = recording.fragments[fragment].previous;
    for (; i != no_fragment && !(color_found && depth_found); i = recording.fragments[i].previous) {
        const FragmentRecord& earlier = recording.fragments[i];
        if (!color_found && earlier.written()) {
            before.color = !recording.float_color() ? framebuffer::unpack(earlier.color)
                                                    : recording.color32f[i];
            before.triangle = recording.run_of_fragment(i).triangle;
            color_found = true;
        }
        if (!depth_found && earlier.depth_written) {
            before.depth = earlier.depth;
            depth_found = true;
        }
    }
    if (!color_found) {
        before.color = !recording.float_color()
                           ? framebuffer::unpack(framebuffer::pack(settings.background))
                           : settings.background;
    }
    if (!depth_found) {
        before.depth = framebuffer::store_depth(settings.depth_clear(), settings.depth_format);
    }
    return before;
}

} // namespace hs::trace
