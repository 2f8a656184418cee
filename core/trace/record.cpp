// Recording a frame: the pipeline draws into pixels that know their owner, and a sink keeps the
// facts.
#include "core/pipeline/draw_frame.hpp"
#include "core/pipeline/order_refusal.hpp"
#include "core/trace/recording.hpp"
#include "core/trace/tally.hpp"

#include <chrono>
#include <new>
#include <optional>
#include <utility>

namespace hs::trace {
namespace {

constexpr StepId index_spacing =
    2048; // steps; a re-run of that many takes well under a millisecond

/// Where a recorded frame's fragments read and write. A fragment asks for the same pixel several
/// times: it is looked up once.
class RecordedPixels {
public:
    RecordedPixels(const scene::Settings& settings, const SampleLog& log)
        : buffer_(settings), color_format_(settings.color_format), log_(log) {}

    [[nodiscard]] float depth(PixelPos p) const { return buffer_[p].depth; }
    [[nodiscard]] glm::vec4 color(PixelPos p) const { return buffer_.color(p); }
    [[nodiscard]] bool closed(PixelPos p) const { return buffer_[p].overdraw > 0; }
    void close(PixelPos) {} // counting what is written does
    void set_depth(PixelPos p, float depth) { writable(p).depth = depth; }
    void set_color(PixelPos p, const glm::vec4& color) {
        writable(p).color = framebuffer::pack(color);
        if (buffer_.float_color()) {
            buffer_.set_color32f(p, color);
        }
    }

    /// Several samples a pixel: the log holds them.
    [[nodiscard]] framebuffer::PixelSamples samples(PixelPos p) const {
        return log_.after(buffer_[p].last_fragment);
    }
    /// They join the log when their fragment ends; the pixel shows what they resolve to.
    void set_samples(PixelPos p, const framebuffer::PixelSamples& samples) {
        written_ = log_.stored(samples);
        const framebuffer::SampleValue resolved = framebuffer::resolve(*written_, color_format_);
        set_color(p, resolved.color);
        set_depth(p, resolved.depth);
    }
    /// What the fragment that ends now leaves in the samples of its pixel.
    [[nodiscard]] framebuffer::PixelSamples take_samples(PixelPos p) {
        const framebuffer::PixelSamples result = written_ ? *written_ : samples(p);
        written_.reset();
        return result;
    }

    [[nodiscard, gnu::always_inline]] PixelRecord& writable(PixelPos p) {
        if (pixel_ == nullptr || p != at_) {
            at_ = p;
            pixel_ = &buffer_.writable(p);
        }
        return *pixel_;
    }
    /// A copy, which shares tiles: the next write must look its pixel up again.
    [[nodiscard]] PixelBuffer snapshot() {
        pixel_ = nullptr;
        return buffer_;
    }
    [[nodiscard]] const PixelBuffer& buffer() const { return buffer_; }

private:
    PixelBuffer buffer_;
    scene::ColorFormat color_format_;
    const SampleLog& log_;
    std::optional<framebuffer::PixelSamples> written_; ///< by the fragment being drawn
    PixelPos at_;
    PixelRecord* pixel_ = nullptr;
};

/// Counts up but stays at the largest value.
void count_saturating(std::uint16_t& counter) {
    counter = static_cast<std::uint16_t>(counter + (counter < 0xFFFFU ? 1 : 0));
}

/// The recording sink.
class FactsTrace {
public:
    static constexpr bool ignores_values = true; // a re-run finds them again

    FactsTrace(Recording& recording, RecordedPixels& pixels, const RecordOptions& options)
        : recording_(recording),
          pixels_(pixels),
          options_(options),
          spacing_(options.checkpoint_spacing) {}

    void vertex_run(std::uint32_t, std::uint32_t, int steps) {
        step_ += static_cast<StepId>(steps);
        ++counters_.vertices;
    }

    template <typename State>
    void order_step(const visibility::OrderEvent& event, const State&) {
        ++step_;
        ++counters_.decisions[static_cast<std::size_t>(event.kind)];
        recording_.decisions.add(event);
    }

    void sweep_begin(int) {
        if (recording_.first_sweep_step == 0) {
            recording_.first_sweep_step = step_;
        }
        draw_ = static_cast<std::uint32_t>(recording_.draw_steps.size());
        piece_ = 0;
        recording_.draw_steps.push_back(step_);
        begin_draw();
    }
    void pixel_begin(PixelPos) { piece_ = 0; } // where a re-run may begin
    template <typename State>
    void sweep_step(const visibility::SweepEvent& event, const State&) {
        step(StepKind::sweep);
        ++counters_.sweeps[static_cast<std::size_t>(event.kind)];
    }
    void shown(const pipeline::PieceName& shown) {
        object_ = shown.object;
        frame_triangle_ = recording_.objects[shown.object].first_triangle + shown.triangle;
        piece_ = shown.piece;
        depth_format_ = recording_.frame->calls()[object_].settings.depth_format;
        run_open_ = false;
        geometry::TriangleVerdict& verdict = recording_.triangles[frame_triangle_].verdict;
        if (verdict == geometry::TriangleVerdict::unseen) {
            verdict = geometry::TriangleVerdict::drawn;
        }
    }

    void triangle_begin(std::uint32_t object, std::uint32_t triangle) {
        if (object != object_) {
            keep_between_objects();
        }
        object_ = object;
        draw_ = static_cast<std::uint32_t>(recording_.draw_steps.size());
        frame_triangle_ = recording_.objects[object].first_triangle + triangle;
        piece_ = 0;
        clipped_ = false;
        depth_format_ = recording_.frame->calls()[object].settings.depth_format;
        recording_.draw_steps.push_back(step_);
        recording_.objects[object].last_draw = draw_;
        TriangleRecord& record = recording_.triangles[frame_triangle_];
        record.last_draw = draw_;
        record.first_step = record.first_step == 0 ? step_ : record.first_step;
        begin_draw();
    }
    void part_begin(int) {}
    void outcodes(const std::array<geometry::Outcode, 3>&) { step(StepKind::outcodes); }
    void clipped(geometry::ClipPlane, const geometry::ClipPolygon&, const geometry::ClipPolygon&) {
        step(StepKind::clip_plane, true, !std::exchange(clipped_, true));
    }
    void piece_begin(int piece) { piece_ = piece; }
    void divided(const std::array<geometry::WindowVertex, 3>&) { step(StepKind::divide); }
    void mapped(const std::array<geometry::WindowVertex, 3>&) { step(StepKind::viewport); }
    void faced(std::int64_t, geometry::TriangleVerdict) { step(StepKind::facing); }
    void oriented(double, geometry::TriangleVerdict) { step(StepKind::facing); }
    void set_up(const raster::TriangleSetup&) {
        step(StepKind::setup);
        run_open_ = false;
    }
    void planes_set_up(const raster::HomogeneousSetup&) {
        step(StepKind::setup);
        run_open_ = false;
    }
    void line_set_up(const raster::LineSetup&) {
        step(StepKind::setup);
        run_open_ = false;
    }
    void line_stepped(const raster::LineStep&) { step(StepKind::line_step); }
    void unit(int unit) {
        if (step_ - recording_.index.back().step >= index_spacing) {
            add_index_entry(unit);
        }
    }
    void cost(const raster::Cost& cost) { count_cost(counters_, cost); }
    void edge_test(PixelPos, const raster::EdgeValues&, bool) { step(StepKind::edge_test); }
    void edge_tests(int pixels) {
        const auto count = static_cast<std::uint64_t>(pixels);
        step_ += count;
        count_cost(
            counters_, {.pixels = count, .evaluations = count * raster::cost_of_asking.evaluations}
        );
    }
    void sample_tested(const raster::SampleTest&) { step(StepKind::sample_test); }
    void tile_tested(const raster::TileTest&) { step(StepKind::tile_test); }
    void edges_bucketed(const raster::EdgeTable&) { step(StepKind::edge_table); }
    void edges_activated(const raster::ActiveEdges&) { step(StepKind::active_edges); }
    void span_found(const raster::Span&) { step(StepKind::span); }
    void planes_tested(PixelPos, const raster::PlaneTest&) { step(StepKind::plane_test); }

    void fragment_sampled(const pipeline::FragmentSamples& sampled) {
        sampled_ = sampled;
        passed_ = 0;
    }
    void interpolated(const raster::Fragment& fragment) {
        step(StepKind::interpolate);
        tested_ = false;
        depth_written_ = false;
        pixel_ = fragment.pixel;
        depth_ = framebuffer::store_depth(fragment.depth, depth_format_);
    }
    void shaded(const shading::ShadedFragment&) { step(StepKind::shade); }
    void scissor_tested(bool inside) {
        step(StepKind::scissor_test, inside, !std::exchange(tested_, true));
    }
    void closed_tested(bool open) {
        step(StepKind::closed_test, open, !std::exchange(tested_, true));
    }
    void depth_tested(const pipeline::DepthTest& test) {
        step(StepKind::depth_test, !test.fatal(), !std::exchange(tested_, true));
    }
    void merged(const pipeline::Merge& merge) {
        step(StepKind::merge);
        depth_written_ = merge.depth_written;
    }
    void samples_merged(const pipeline::SamplesMerge& merge) {
        step(StepKind::merge);
        passed_ = merge.written;
        depth_written_ = merge.depth_written && raster::has_sample(merge.written, 0);
    }
    [[gnu::always_inline]] void fragment_end(fragment::FragmentFate fate) {
        const auto number = static_cast<std::uint32_t>(recording_.fragments.size());
        if (!run_open_) {
            recording_.runs.push_back({number, frame_triangle_, static_cast<std::uint16_t>(piece_)}
            );
            run_open_ = true;
        }
        if (recording_.samples.active()) {
            depth_ = sampled_.first_depth;
            recording_.samples.push_back(pixels_.take_samples(pixel_));
        }
        PixelRecord& pixel = pixels_.writable(pixel_);
        count_saturating(pixel.complexity);
        if (fate == fragment::FragmentFate::written) {
            count_saturating(pixel.overdraw);
            pixel.triangle = frame_triangle_;
        }
        FragmentRecord& record = recording_.fragments.append();
        record.x = static_cast<std::uint16_t>(pixel_.x);
        record.y = static_cast<std::uint16_t>(pixel_.y);
        record.depth = depth_;
        record.color = pixel.color;
        record.previous = std::exchange(pixel.last_fragment, number);
        record.fate = fate;
        record.depth_written = depth_written_;
        record.coverage = sampled_.covered;
        record.passed = passed_;
        if (pixels_.buffer().float_color()) {
            recording_.color32f.push_back(pixels_.buffer().color(pixel_));
        }
    }
    void triangle_end(geometry::TriangleVerdict verdict, geometry::Outcode crossed) {
        TriangleRecord& record = recording_.triangles[frame_triangle_];
        const bool first = record.first_step == recording_.draw_steps.back(); // of its parts
        const unsigned planes = record.crossed | crossed;
        record.verdict = first ? verdict : pipeline::stronger(record.verdict, verdict);
        record.crossed = static_cast<geometry::Outcode>(planes);
    }

    /// After the vertex stage.
    void vertex_stage_end() { recording_.first_order_step = step_; }
    /// After the ordering.
    void order_end() { recording_.first_triangle_step = step_; }
    /// After the last triangle: every pixel is resolved, if it has several samples.
    void resolved(PixelPos, const framebuffer::PixelSamples&, const framebuffer::SampleValue&) {
        step(StepKind::resolve);
    }
    void triangles_end() {
        recording_.first_resolve_step = step_;
        if (recording_.first_sweep_step == 0) {
            recording_.first_sweep_step = step_;
        }
    }
    void frame_end() {
        recording_.end_step = step_;
        recording_.counters = counters_;
    }

private:
    void step(StepKind kind, bool passed = true, bool first = false) {
        ++step_;
        count_step(counters_, kind, passed, first);
    }

    void begin_draw() {
        if (recording_.index.empty() || step_ - recording_.index.back().step >= index_spacing) {
            add_index_entry(-1);
        }
    }

    void add_index_entry(int unit) {
        const auto fragments = static_cast<std::uint32_t>(recording_.fragments.size());
        recording_.index.push_back(
            {.step = step_,
             .fragment = fragments,
             .draw = draw_,
             .piece = piece_,
             .unit = unit,
             .before = counters_}
        );
        if (fragments - last_checkpoint_ >= spacing_) {
            add_checkpoint(fragments);
        }
    }

    /// Steps by object or stage cross many fragments at once.
    void keep_between_objects() {
        const auto fragments = static_cast<std::uint32_t>(recording_.fragments.size());
        if (fragments - last_checkpoint_ >= spacing_ / 64) {
            add_checkpoint(fragments);
        }
    }

    /// Keeps the framebuffer; when the budget is full, doubles the spacing and lets every second
    /// checkpoint go.
    void add_checkpoint(std::uint32_t fragments) {
        const std::size_t size = pixels_.buffer().bytes(); // never more, as tiles are shared
        std::vector<Checkpoint>& kept = recording_.checkpoints;
        last_checkpoint_ = fragments;
        while (!kept.empty() && (kept.size() + 1) * size > options_.checkpoint_budget) {
            spacing_ *= 2;
            for (std::size_t i = 0; 2 * i + 1 < kept.size(); ++i) {
                std::swap(kept[i], kept[2 * i + 1]);
            }
            kept.resize(kept.size() / 2);
        }
        if ((kept.size() + 1) * size <= options_.checkpoint_budget) {
            kept.push_back({fragments, pixels_.snapshot()});
        }
    }

    Recording& recording_;
    RecordedPixels& pixels_;
    const RecordOptions& options_;
    Counters counters_;
    StepId step_ = 1; // 0 is `start`
    std::uint32_t spacing_;
    std::uint32_t last_checkpoint_ = 0;
    std::uint32_t object_ = 0;
    std::uint32_t draw_ = 0;
    std::uint32_t frame_triangle_ = 0;
    int piece_ = 0;
    bool clipped_ = false;
    bool run_open_ = false;
    bool tested_ = false;
    bool depth_written_ = false;
    pipeline::FragmentSamples sampled_;
    raster::CoverageMask passed_ = 0;
    scene::DepthFormat depth_format_ = scene::DepthFormat::float32;
    PixelPos pixel_;
    float depth_ = 0.0F;
};
static_assert(pipeline::TraceSink<FactsTrace>);
static_assert(pipeline::AnyOrderSink<FactsTrace>);
static_assert(pipeline::AnySweepSink<FactsTrace>);
static_assert(framebuffer::PixelTarget<RecordedPixels>);
static_assert(framebuffer::SampleTarget<RecordedPixels>);

/// Lays out the frame-wide tables: who starts where.
void number_objects(Recording& recording) {
    StepId step = 1;
    std::uint32_t vertex = 0;
    std::uint32_t triangle = 0;
    for (const pipeline::DrawCall& call : recording.frame->calls()) {
        const auto vertices = static_cast<std::uint32_t>(call.vertex.mesh->positions.size());
        const std::uint32_t triangles = call.primitive_count();
        const int steps = pipeline::steps_per_vertex(call.settings.shading);
        recording.objects.push_back({vertex, vertices, triangle, triangles, step, steps, 0});
        step += StepId{vertices} * static_cast<StepId>(steps);
        vertex += vertices;
        triangle += triangles;
    }
    recording.triangles.resize(triangle);
    recording.runs.reserve(triangle);
}

/// Draws everything in its order, asking now and then whether to go on. False: stopped, or out of
/// fragment numbers.
enum class Outcome : std::uint8_t {
    complete,
    stopped,
    too_many_fragments
};

Outcome draw_triangles(
    Recording& recording, RecordedPixels& pixels, FactsTrace& facts, const RecordOptions& options
) {
    constexpr std::size_t between_questions = 4096; // draws
    constexpr std::size_t most_fragments = std::size_t{1} << 31U;
    const pipeline::DrawOrder& order = recording.order;
    for (std::size_t i = 0; i < order.draws.size(); ++i) {
        if (i % between_questions == 0 && options.progress &&
            !options.progress(static_cast<double>(i) / static_cast<double>(order.draws.size()))) {
            return Outcome::stopped;
        }
        pipeline::run_draw(*recording.frame, order, order.draws[i], {}, pixels, facts);
        if (recording.fragments.size() > most_fragments) {
            return Outcome::too_many_fragments;
        }
    }
    return Outcome::complete;
}

Result<std::shared_ptr<const Recording>>
record_frame(std::shared_ptr<const scene::Scene> scene, const RecordOptions& options) {
    const auto began = std::chrono::steady_clock::now();
    auto recording = std::make_shared<Recording>();
    recording->frame = std::make_shared<pipeline::Frame>(std::move(scene));
    const scene::Scene& source = recording->scene();
    number_objects(*recording);

    // Vertex stage of every object, the order of triangles, then every triangle
    recording->samples = SampleLog(source.settings);
    RecordedPixels pixels(source.settings, recording->samples);
    FactsTrace facts(*recording, pixels, options);
    pipeline::shade_vertices(*recording->frame, facts, options.threads);
    facts.vertex_stage_end();
    if (const auto complaint = pipeline::refuse_order(*recording->frame)) {
        return Diagnostic{.file = source.file, .message = *complaint};
    }
    recording->order = pipeline::order_triangles(*recording->frame, facts);
    recording->draw_steps.reserve(recording->order.draws.size());
    facts.order_end();
    const Outcome outcome = draw_triangles(*recording, pixels, facts, options);
    if (outcome == Outcome::stopped) {
        return Diagnostic{.file = source.file, .message = "recording was stopped"};
    }
    if (outcome == Outcome::too_many_fragments) {
        return Diagnostic{
            .file = source.file,
            .message = "more than 2147483648 fragments; record at a smaller size"};
    }
    facts.triangles_end();
    if (recording->samples.active()) {
        pipeline::resolve_frame(source.settings, pixels, facts);
    }
    facts.frame_end();
    recording->final_pixels = pixels.snapshot();
    recording->seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return std::shared_ptr<const Recording>(std::move(recording));
}

} // namespace

Result<std::shared_ptr<const Recording>>
record(std::shared_ptr<const scene::Scene> scene, const RecordOptions& options) {
    const std::string file = scene->file;
    try {
        return record_frame(std::move(scene), options);
    } catch (const std::bad_alloc&) {
        return Diagnostic{
            .file = file, .message = "not enough memory to record this frame; use a smaller size"};
    }
}

} // namespace hs::trace
