#include "core/trace/sweep_detail.hpp"

#include "core/pipeline/run_draw.hpp"
#include "core/trace/past_pixels.hpp"

#include <array>

namespace hs::trace {
namespace {

/// Keeps decisions until the step has happened, and then the state. Goes on: a sink never steers.
class SweepUntil : public pipeline::NullTrace {
public:
    SweepUntil(SweepDetail& detail, const Step& step) : detail_(detail), step_(step) {}

    template <typename State>
    void sweep_step(const visibility::SweepEvent& event, const State& state) {
        if (reached_) {
            return;
        }
        detail_.decisions.push_back(event);
        see(state);
        const std::uint32_t ordinal = seen_[static_cast<std::size_t>(event.kind)]++;
        if (step_.kind == StepKind::sweep && step_.sweep == event.kind &&
            step_.ordinal == ordinal) {
            reach();
        }
    }
    void interpolated(const raster::Fragment& fragment) {
        if (!reached_ && step_.in_fragment() && fragment.pixel == step_.pixel) {
            reach();
        }
    }

private:
    // A line of pixels may be long: it is copied once, while its row still runs
    void see(const visibility::ScanState& state) { scan_ = &state; }
    void see(const visibility::LineBuffer& line) { line_ = &line; }
    void see(const visibility::RayCast& ray) { detail_.ray = ray; }

    void reach() {
        reached_ = true;
        if (scan_ != nullptr) {
            detail_.scan = *scan_;
        }
        if (line_ != nullptr) {
            detail_.line = *line_;
        }
    }

    SweepDetail& detail_;
    const Step& step_;
    const visibility::ScanState* scan_ = nullptr;
    const visibility::LineBuffer* line_ = nullptr;
    std::array<std::uint32_t, visibility::sweep_event_kind_count> seen_{};
    bool reached_ = false;
};
static_assert(pipeline::TraceSink<SweepUntil>);
static_assert(pipeline::AnySweepSink<SweepUntil>);

} // namespace

SweepDetail sweep_detail(const Recording& recording, const Step& step) {
    HS_CHECK(recording.in_row(step.id), "a step of a row");
    SweepDetail detail;
    const bool rays = recording.settings().visibility == scene::Visibility::ray_cast;
    const pipeline::Draw& draw = recording.order.draws[recording.draw_of_step(step.id)];
    detail.row = draw.row;
    detail.pixel = step.pixel;
    pipeline::TriangleScope scope;
    if (rays) {
        scope = {0, step.unit, 0, step.unit + 1};
    }
    const std::uint32_t no_one = no_fragment;
    PastPixels pixels(recording, no_one);
    SweepUntil trace(detail, step);
    pipeline::run_draw(*recording.frame, recording.order, draw, scope, pixels, trace);
    return detail;
}

} // namespace hs::trace
