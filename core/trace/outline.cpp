#include "core/trace/outline.hpp"

#include "core/base/check.hpp"
#include "core/pipeline/run_draw.hpp"
#include "core/trace/past_pixels.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace hs::trace {
namespace {

/// The sink of a re-run: writes down every step it hears of, from the resume point on.
class OutlineTrace {
public:
    OutlineTrace(const Recording& recording, Outline& outline, const IndexEntry& from, StepId end)
        : recording_(recording),
          outline_(outline),
          end_(end),
          fragment_(from.fragment),
          listening_(from.unit < 0) {
        outline_.first_step = from.step;
        at_.id = from.step;
    }

    [[nodiscard]] const std::uint32_t& fragment() const { return fragment_; }

    void vertex_run(std::uint32_t, std::uint32_t, int) {}
    void triangle_begin(std::uint32_t object, std::uint32_t triangle) {
        const scene::Primitive primitive = recording_.frame->calls()[object].primitive(triangle);
        const bool numbered = primitive.kind != scene::PrimitiveKind::triangle;
        at_ = {
            .id = at_.id,
            .object = object,
            .triangle = triangle,
            .primitive = primitive.kind,
            .number = numbered ? primitive.number : 0};
    }
    void sweep_begin(int row) {
        at_ = {.id = at_.id, .pixel = {0, row}};
        ordinals_ = {};
    }
    void pixel_begin(PixelPos pixel) {
        at_ = {.id = at_.id, .pixel = pixel};
        ordinals_ = {};
    }
    template <typename State>
    void sweep_step(const visibility::SweepEvent& event, const State&) {
        const PixelPos place = at_.pixel;
        if (event.polygon >= 0) {
            shown(recording_.order.sweep->polygon(event.polygon));
        }
        at_.of_polygon = event.polygon >= 0;
        at_.sweep = event.kind;
        at_.ordinal = ordinals_[static_cast<std::size_t>(event.kind)]++;
        at_.pixel.x =
            event.kind == visibility::SweepEventKind::depth ? static_cast<int>(event.x) : place.x;
        add(StepKind::sweep);
        at_ = {.id = at_.id, .unit = at_.unit, .pixel = place};
    }
    void shown(const pipeline::PieceName& shown) {
        at_ = {
            .id = at_.id,
            .object = shown.object,
            .triangle = shown.triangle,
            .clipped = shown.clipped,
            .piece = shown.piece,
            .unit = at_.unit,
            .pixel = at_.pixel};
    }
    void part_begin(int first_piece) {
        at_.part = true;
        at_.piece = first_piece;
    }
    void outcodes(const std::array<geometry::Outcode, 3>&) { add(StepKind::outcodes); }
    void
    clipped(geometry::ClipPlane plane, const geometry::ClipPolygon&, const geometry::ClipPolygon&) {
        at_.clipped = true;
        at_.plane = plane;
        add(StepKind::clip_plane);
        at_.plane = geometry::ClipPlane::near;
    }
    void piece_begin(int piece) {
        at_ = {
            .id = at_.id,
            .object = at_.object,
            .triangle = at_.triangle,
            .primitive = at_.primitive,
            .number = at_.number,
            .part = at_.part,
            .clipped = at_.clipped,
            .piece = piece};
    }
    void divided(const std::array<geometry::WindowVertex, 3>&) { add(StepKind::divide); }
    void mapped(const std::array<geometry::WindowVertex, 3>&) { add(StepKind::viewport); }
    void faced(std::int64_t, geometry::TriangleVerdict) { add(StepKind::facing); }
    void oriented(double, geometry::TriangleVerdict) { add(StepKind::facing); }
    void set_up(const raster::TriangleSetup&) { add(StepKind::setup); }
    void planes_set_up(const raster::HomogeneousSetup&) { add(StepKind::setup); }
    void line_set_up(const raster::LineSetup&) { add(StepKind::setup); }
    void unit(int unit) {
        if (!std::exchange(listening_, true)) {
            spent_ = {}; // a re-run that resumes inside a triangle begins with a unit
        }
        at_.unit = unit;
    }
    void cost(const raster::Cost& cost) { spent_ += cost; }
    void edge_test(PixelPos pixel, const raster::EdgeValues&, bool inside) {
        at_.pixel = pixel;
        at_.covered = inside;
        add(StepKind::edge_test);
    }
    void sample_tested(const raster::SampleTest& test) {
        at_.pixel = test.pixel;
        at_.covered = test.inside;
        at_.sample = test.sample;
        add(StepKind::sample_test);
        at_.sample = -1;
    }
    void planes_tested(PixelPos pixel, const raster::PlaneTest& test) {
        at_.pixel = pixel;
        at_.covered = test.inside;
        add(StepKind::plane_test);
    }
    void line_stepped(const raster::LineStep& line) {
        at_.pixel = line.pixel;
        at_.covered = true;
        add(StepKind::line_step);
    }
    void tile_tested(const raster::TileTest& tile) {
        at_.pixel = tile.origin;
        at_.tile_size = tile.size;
        add(StepKind::tile_test);
        at_.tile_size = 0;
    }
    void edges_bucketed(const raster::EdgeTable& table) {
        add_scan(StepKind::edge_table, table.place);
    }
    void edges_activated(const raster::ActiveEdges& active) {
        at_.pixel = {0, active.row};
        add_scan(StepKind::active_edges, active.place);
    }
    void span_found(const raster::Span& span) {
        at_.pixel = {0, span.row};
        add_scan(StepKind::span, span.place);
    }
    void fragment_sampled(const pipeline::FragmentSamples& sampled) { at_.sample = sampled.sample; }
    void interpolated(const raster::Fragment& fragment) {
        at_.pixel = fragment.pixel;
        at_.covered = true;
        at_.fragment = fragment_;
        add(StepKind::interpolate);
    }
    void shaded(const shading::ShadedFragment&) { add(StepKind::shade); }
    void scissor_tested(bool inside) { add_test(StepKind::scissor_test, inside, !inside); }
    void closed_tested(bool open) { add_test(StepKind::closed_test, open, !open); }
    void depth_tested(const pipeline::DepthTest& test) {
        const std::int32_t of_fragment = std::exchange(at_.sample, test.sample);
        add_test(StepKind::depth_test, test.passed, test.fatal());
        at_.sample = of_fragment;
    }
    void merged(const pipeline::Merge&) { add(StepKind::merge); }
    void samples_merged(const pipeline::SamplesMerge&) { add(StepKind::merge); }
    void fragment_end(fragment::FragmentFate fate) {
        const bool logged = fragment_ < recording_.fragments.size() &&
                            recording_.fragments[fragment_].pixel() == at_.pixel &&
                            recording_.fragments[fragment_].fate == fate;
        outline_.divergences += logged ? 0U : 1U;
        ++fragment_;
        at_.fragment = 0;
        at_.sample = -1;
    }
    void triangle_end(geometry::TriangleVerdict, geometry::Outcode) {}
    void resolved(PixelPos, const framebuffer::PixelSamples&, const framebuffer::SampleValue&) {}

private:
    void add(StepKind kind) {
        if (!listening_ || at_.id >= end_) {
            return; // geometry repeated on the way to the resume point, or beyond the stretch
        }
        at_.kind = kind;
        outline_.steps.push_back(at_);
        outline_.costs.push_back(std::exchange(spent_, {}));
        ++at_.id;
    }
    void add_scan(StepKind kind, const raster::ScanPlace& place) {
        at_.sample = place.sample;
        add(kind);
        at_.sample = -1;
    }
    void add_test(StepKind kind, bool passed, bool fatal) {
        at_.passed = passed;
        at_.fatal = fatal;
        add(kind);
        at_.passed = true;
        at_.fatal = false;
    }

    const Recording& recording_;
    Outline& outline_;
    StepId end_;
    std::uint32_t fragment_;
    bool listening_;
    Step at_;
    raster::Cost spent_;
    std::array<std::uint32_t, visibility::sweep_event_kind_count>
        ordinals_{}; ///< in the row or ray
};
static_assert(pipeline::TraceSink<OutlineTrace>);
static_assert(framebuffer::PixelTarget<PastPixels>);

/// Where a stretch stops: at the next index entry, or after the last draw.
struct Stop {
    StepId step;
    std::uint32_t draw; ///< the first not fully run
    std::int32_t piece;
    std::int32_t unit;
};

Stop stop_after(const Recording& recording, std::size_t entry) {
    if (entry + 1 < recording.index.size()) {
        const IndexEntry& next = recording.index[entry + 1];
        return {next.step, next.draw, next.piece, next.unit};
    }
    return {
        recording.first_resolve_step,
        static_cast<std::uint32_t>(recording.order.draws.size()),
        0,
        -1};
}

} // namespace

std::size_t index_entry_of_step(const Recording& recording, StepId step) {
    HS_DCHECK(
        step >= recording.first_triangle_step && step < recording.first_resolve_step,
        "a step of the triangle stages"
    );
    const auto after = std::upper_bound(
        recording.index.begin(),
        recording.index.end(),
        step,
        [](StepId s, const IndexEntry& entry) { return s < entry.step; }
    );
    return static_cast<std::size_t>(after - recording.index.begin()) - 1;
}

Outline outline(const Recording& recording, std::size_t entry) {
    const IndexEntry& from = recording.index[entry];
    const Stop stop = stop_after(recording, entry);
    Outline result;
    result.steps.reserve(stop.step - from.step);
    result.costs.reserve(stop.step - from.step);
    OutlineTrace trace(recording, result, from, stop.step);
    PastPixels pixels(recording, trace.fragment());

    const std::vector<pipeline::Draw>& draws = recording.order.draws;
    for (std::uint32_t i = from.draw; i < draws.size(); ++i) {
        const bool last = i == stop.draw;
        if (last && stop.unit < 0) {
            return result;
        }
        pipeline::TriangleScope scope;
        if (i == from.draw && from.unit >= 0) {
            scope.first_piece = from.piece;
            scope.first_unit = from.unit;
        }
        if (last) {
            scope.last_piece = stop.piece;
            scope.last_unit = stop.unit;
        }
        pipeline::run_draw(*recording.frame, recording.order, draws[i], scope, pixels, trace);
        if (last) {
            return result;
        }
    }
    return result;
}

} // namespace hs::trace
