#include "core/trace/trail.hpp"

#include "core/pipeline/run_draw.hpp"
#include "core/trace/detail.hpp"
#include "core/trace/past_pixels.hpp"

namespace hs::trace {
namespace {

/// Writes down what the traversal of the step's piece says until the step has happened.
class TrailTrace : public raster::SilentTraversal, public visibility::SilentSweep {
public:
    TrailTrace(Trail& trail, const Step& step) : trail_(trail), step_(step) {}

    void vertex_run(std::uint32_t, std::uint32_t, int) {}
    void triangle_begin(std::uint32_t, std::uint32_t) {}
    void part_begin(int) {}
    void outcodes(const std::array<geometry::Outcode, 3>&) {}
    void clipped(geometry::ClipPlane, const geometry::ClipPolygon&, const geometry::ClipPolygon&) {}
    void piece_begin(int) {}
    void divided(const std::array<geometry::WindowVertex, 3>&) {}
    void mapped(const std::array<geometry::WindowVertex, 3>&) {}
    void faced(std::int64_t, geometry::TriangleVerdict) {}
    void oriented(double, geometry::TriangleVerdict) {}
    void set_up(const raster::TriangleSetup&) {}
    void planes_set_up(const raster::HomogeneousSetup&) {}
    void line_set_up(const raster::LineSetup&) {}
    void sweep_begin(int) {}
    void pixel_begin(PixelPos) {}
    void shown(const pipeline::PieceName&) {}

    void line_stepped(const raster::LineStep& line) {
        visit(line.pixel, true, StepKind::line_step);
    }
    void edge_test(PixelPos pixel, const raster::EdgeValues&, bool inside) {
        visit(pixel, inside, StepKind::edge_test);
    }
    void sample_tested(const raster::SampleTest& test) {
        if (reached_) {
            return;
        }
        if (test.sample == 0) {
            trail_.visits.push_back({test.pixel});
        }
        TrailVisit& visit = trail_.visits.back();
        ++visit.samples_asked;
        if (test.inside) {
            visit.covered = true;
            visit.samples |= raster::mask_of(test.sample);
        }
        reached_ = is_step(StepKind::sample_test, test.pixel) && step_.sample == test.sample;
    }
    void planes_tested(PixelPos pixel, const raster::PlaneTest& test) {
        visit(pixel, test.inside, StepKind::plane_test);
    }
    void tile_tested(const raster::TileTest& tile) {
        if (!reached_) {
            trail_.tiles.push_back(tile);
            reached_ = is_step(StepKind::tile_test, tile.origin) && tile.size == step_.tile_size;
        }
    }
    void edges_activated(const raster::ActiveEdges& active) {
        reached_ = reached_ || (is_step(StepKind::active_edges, {0, active.row}) &&
                                active.place.sample == step_.sample);
    }
    void span_found(const raster::Span& span) {
        if (!reached_) {
            trail_.spans.push_back(span);
            reached_ = is_step(StepKind::span, {0, span.row}) && span.place.sample == step_.sample;
        }
    }
    void fragment_sampled(const pipeline::FragmentSamples& sampled) { sampled_ = sampled.covered; }
    /// A pixel inside a span or an accepted tile becomes a fragment without being asked.
    void interpolated(const raster::Fragment& fragment) {
        const bool visited = !trail_.visits.empty() && trail_.visits.back().pixel == fragment.pixel;
        if (!reached_ && !visited) {
            trail_.visits.push_back({fragment.pixel, true});
        }
        if (!reached_) {
            trail_.visits.back().samples |= sampled_;
        }
        reached_ = reached_ || (step_.in_fragment() && step_.pixel == fragment.pixel);
    }
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
    [[nodiscard]] bool is_step(StepKind kind, PixelPos place) const {
        return step_.kind == kind && step_.pixel == place;
    }
    void visit(PixelPos pixel, bool inside, StepKind kind) {
        if (!reached_) {
            trail_.visits.push_back({pixel, inside});
            reached_ = is_step(kind, pixel);
        }
    }

    Trail& trail_;
    const Step& step_;
    bool reached_ = false;
    raster::CoverageMask sampled_ = 0; ///< with several samples, those of the fragment
};
static_assert(pipeline::TraceSink<TrailTrace>);

/// How many pixels the traversal may come to.
std::size_t pixels_ahead(const Recording& recording, const Step& step) {
    const pipeline::DrawCall& call = recording.frame->calls()[step.object];
    PixelRect region = call.drawable();
    const bool boxed = call.settings.traversal != scene::TraversalKind::brute_force;
    const auto detail = triangle_detail(recording, step.object, step.triangle);
    const auto piece = static_cast<std::size_t>(step.piece);
    if (piece < detail.pieces.size() && detail.pieces[piece].line) {
        return static_cast<std::size_t>(detail.pieces[piece].line->steps) + 1;
    }
    if (boxed && piece < detail.pieces.size() && detail.pieces[piece].setup) {
        region = detail.pieces[piece].setup->bounds;
    }
    return static_cast<std::size_t>(region.width()) * static_cast<std::size_t>(region.height());
}

} // namespace

Trail trail(const Recording& recording, const Step& step, std::size_t most_pixels) {
    Trail result;
    if (!step.in_unit() || recording.in_row(step.id)) {
        return result;
    }
    result.whole = pixels_ahead(recording, step) <= most_pixels;
    const pipeline::TriangleScope scope{
        .first_piece = step.piece,
        .first_unit = result.whole ? 0 : step.unit,
        .last_piece = step.piece,
        .last_unit = step.unit + 1};
    const std::uint32_t no_one = no_fragment;
    PastPixels pixels(recording, no_one);
    TrailTrace trace(result, step);
    const pipeline::Draw& draw = recording.order.draws[recording.draw_of_step(step.id)];
    pipeline::run_draw(*recording.frame, recording.order, draw, scope, pixels, trace);
    return result;
}

} // namespace hs::trace
