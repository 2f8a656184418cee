#include "tests/support/fresh_run.hpp"

#include "core/base/hash.hpp"
#include "core/pipeline/draw_frame.hpp"

namespace hs::tests {
namespace {

using trace::StepKind;

/// Copies the state at every step and goes on. Written without the recorder's counting on purpose.
class MomentTrace {
public:
    MomentTrace(const framebuffer::Framebuffer& target, std::vector<Moment>& moments)
        : target_(target), moments_(moments) {}

    void vertex_run(std::uint32_t, std::uint32_t, int steps) {
        ++counters_.vertices;
        for (int i = 0; i < steps; ++i) {
            add(static_cast<StepKind>(static_cast<int>(StepKind::vertex_world) + i));
        }
    }
    template <typename State>
    void order_step(const visibility::OrderEvent& event, const State&) {
        ++counters_.decisions[static_cast<std::size_t>(event.kind)];
        add(StepKind::order);
    }
    void sweep_begin(int) {}
    void pixel_begin(PixelPos) {}
    void shown(const pipeline::PieceName&) {}
    template <typename State>
    void sweep_step(const visibility::SweepEvent& event, const State&) {
        ++counters_.sweeps[static_cast<std::size_t>(event.kind)];
        add(StepKind::sweep);
    }
    void triangle_begin(std::uint32_t, std::uint32_t) { clipped_ = false; }
    void part_begin(int) {}
    void outcodes(const std::array<geometry::Outcode, 3>&) {
        ++counters_.triangles;
        add(StepKind::outcodes);
    }
    void clipped(geometry::ClipPlane, const geometry::ClipPolygon&, const geometry::ClipPolygon&) {
        counters_.clipped += clipped_ ? 0U : 1U;
        clipped_ = true;
        add(StepKind::clip_plane);
    }
    void piece_begin(int) {}
    void divided(const std::array<geometry::WindowVertex, 3>&) {
        ++counters_.pieces;
        add(StepKind::divide);
    }
    void mapped(const std::array<geometry::WindowVertex, 3>&) {
        ++counters_.pieces_mapped;
        add(StepKind::viewport);
    }
    void faced(std::int64_t, geometry::TriangleVerdict) {
        ++counters_.pieces_faced;
        add(StepKind::facing);
    }
    void set_up(const raster::TriangleSetup&) {
        ++counters_.pieces_set_up;
        add(StepKind::setup);
    }
    void unit(int) {}
    void oriented(double, geometry::TriangleVerdict) {
        ++counters_.pieces_faced;
        add(StepKind::facing);
    }
    void planes_set_up(const raster::HomogeneousSetup&) {
        ++counters_.pieces_set_up;
        add(StepKind::setup);
    }
    void line_set_up(const raster::LineSetup&) {
        ++counters_.pieces_set_up;
        add(StepKind::setup);
    }
    void line_stepped(const raster::LineStep&) { add(StepKind::line_step); }
    void cost(const raster::Cost& cost) { counters_.traversal += cost; }
    void edge_test(PixelPos, const raster::EdgeValues&, bool) { add(StepKind::edge_test); }
    void sample_tested(const raster::SampleTest&) { add(StepKind::sample_test); }
    void tile_tested(const raster::TileTest&) { add(StepKind::tile_test); }
    void edges_bucketed(const raster::EdgeTable&) { scan(StepKind::edge_table); }
    void edges_activated(const raster::ActiveEdges&) { scan(StepKind::active_edges); }
    void planes_tested(PixelPos, const raster::PlaneTest&) { add(StepKind::plane_test); }
    void span_found(const raster::Span&) { scan(StepKind::span); }
    void fragment_sampled(const pipeline::FragmentSamples&) {}
    void interpolated(const raster::Fragment&) {
        ++counters_.fragments;
        tests_ = 0;
        add(StepKind::interpolate);
    }
    void shaded(const shading::ShadedFragment&) {
        ++counters_.fragments_shaded;
        add(StepKind::shade);
    }
    void scissor_tested(bool inside) { test(StepKind::scissor_test, inside, 1); }
    void closed_tested(bool open) { test(StepKind::closed_test, open, 3); }
    void depth_tested(const pipeline::DepthTest& t) {
        test(StepKind::depth_test, t.sample < 0 ? t.passed : !t.discards, 2);
    }
    void merged(const pipeline::Merge&) {
        ++counters_.fates[0];
        add(StepKind::merge);
    }
    void samples_merged(const pipeline::SamplesMerge&) {
        ++counters_.fates[0];
        add(StepKind::merge);
    }
    void fragment_end(fragment::FragmentFate) {}
    void triangle_end(geometry::TriangleVerdict, geometry::Outcode) {}
    void resolved(PixelPos, const framebuffer::PixelSamples&, const framebuffer::SampleValue&) {
        add(StepKind::resolve);
    }

    void add(StepKind kind) { moments_.push_back({kind, target_.digest(), counters_}); }

private:
    void scan(StepKind kind) {
        ++counters_.scan_steps;
        add(kind);
    }
    void test(StepKind kind, bool passed, std::size_t fate) {
        counters_.fragments_tested += tests_++ == 0 ? 1U : 0U;
        counters_.fates[fate] += passed ? 0U : 1U;
        add(kind);
    }

    const framebuffer::Framebuffer& target_;
    std::vector<Moment>& moments_;
    trace::Counters counters_;
    bool clipped_ = false;
    int tests_ = 0;
};

} // namespace

std::vector<Moment> fresh_run(const std::shared_ptr<const scene::Scene>& scene) {
    pipeline::Frame frame(scene);
    framebuffer::Framebuffer target(scene->settings);
    std::vector<Moment> moments;
    MomentTrace trace(target, moments);
    trace.add(StepKind::start);
    pipeline::draw_frame(frame, target, trace);
    trace.add(StepKind::end);
    return moments;
}

namespace {

/// A pixel's own color and depth: with several samples, what it was cleared to until it is
/// resolved.
framebuffer::SampleValue shown(const trace::Player& player, PixelPos pixel) {
    const trace::SampleLog& log = player.recording().samples;
    if (log.active() && !player.resolved(pixel)) {
        return log.cleared()[0];
    }
    return {player.color(pixel), player.pixel(pixel).depth};
}

} // namespace

std::uint64_t shown_digest(const trace::Player& player) {
    const trace::Recording& recording = player.recording();
    const scene::ColorFormat format = recording.settings().color_format;
    Digest digest;
    for (int y = 0; y < recording.height(); ++y) {
        for (int x = 0; x < recording.width(); ++x) {
            framebuffer::PixelSamples pixel;
            pixel[0] = shown(player, {x, y});
            framebuffer::add_samples(digest, pixel, format);
            if (recording.samples.active()) {
                framebuffer::add_samples(digest, player.samples({x, y}), format);
            }
        }
    }
    return digest.value();
}

} // namespace hs::tests
