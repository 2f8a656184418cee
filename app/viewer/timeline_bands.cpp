#include "app/viewer/timeline_bands.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hs::viewer {
namespace {

/// A long triangle is asked at this many places only.
constexpr trace::StepId most_asked = 192;
/// More objects than this are narrower than a pixel each.
constexpr std::size_t most_objects = 1000;

} // namespace

void TimelineBands::gather_frame(const trace::Recording& recording) {
    frame_.clear();
    const std::size_t count = recording.objects.size();
    const std::size_t stride = count / most_objects + 1;
    for (std::size_t i = 0; i < count; i += stride) {
        const trace::ObjectRange& object = recording.objects[i];
        if (object.vertex_count > 0) {
            const auto steps = trace::StepId{object.vertex_count} *
                               static_cast<trace::StepId>(object.steps_per_vertex);
            frame_.push_back(
                {object.first_vertex_step,
                 object.first_vertex_step + steps - 1,
                 trace::Stage::vertex,
                 fmt::format("vertices of object {}", i)}
            );
        }
    }
    if (recording.first_order_step < recording.first_triangle_step) {
        frame_.push_back(
            {recording.first_order_step,
             recording.first_triangle_step - 1,
             trace::Stage::visibility,
             "ordering of triangles"}
        );
    }
    gather_draws(recording);
}

/// A band for every stretch of one object's triangles; one for all where there are too many.
void TimelineBands::gather_draws(const trace::Recording& recording) {
    const std::size_t before = frame_.size();
    const std::vector<pipeline::Draw>& draws = recording.order.draws;
    for (std::size_t i = 0; i < recording.first_row_draw(); ++i) {
        const trace::StepId first = recording.draw_steps[i];
        if (i > 0 && draws[i].object == draws[i - 1].object) {
            continue;
        }
        if (i > 0) {
            frame_.back().last = first - 1;
        }
        frame_.push_back(
            {first,
             recording.first_sweep_step - 1,
             trace::Stage::traverse,
             fmt::format(
                 "{} of object {}",
                 recording.frame->calls()[draws[i].object].triangles().empty() ? "lines and points"
                                                                               : "triangles",
                 draws[i].object
             )}
        );
    }
    if (frame_.size() - before > most_objects) {
        frame_.resize(before + 1);
        frame_.back().last = recording.first_sweep_step - 1;
        frame_.back().label = "triangles";
    }
    if (recording.first_sweep_step < recording.first_resolve_step) {
        const bool rays = recording.settings().visibility == scene::Visibility::ray_cast;
        frame_.push_back(
            {recording.first_sweep_step,
             recording.first_resolve_step - 1,
             trace::Stage::visibility,
             rays ? "rays" : "scanlines"}
        );
    }
    if (recording.samples.active()) {
        frame_.push_back(
            {recording.first_resolve_step, recording.end_step - 1, trace::Stage::merge, "resolve"}
        );
    }
}

void TimelineBands::gather_unit(const trace::Recording& recording, std::uint32_t draw) {
    unit_.clear();
    unit_range_.first = recording.draw_steps[draw];
    unit_range_.last = trace::last_step_of_draw(recording, draw);
    const pipeline::Draw& drawn = recording.order.draws[draw];
    if (drawn.row >= 0) {
        unit_range_.label = fmt::format("row {}", drawn.row);
    } else {
        const scene::Primitive primitive =
            recording.frame->calls()[drawn.object].primitive(drawn.triangle);
        unit_range_.label = fmt::format("{} {}", name_of(primitive.kind), primitive.number);
    }
    const trace::StepId count = unit_range_.last - unit_range_.first + 1;
    const trace::StepId stride = (count + most_asked - 1) / most_asked;
    for (trace::StepId id = unit_range_.first; id <= unit_range_.last; id += stride) {
        const trace::Stage stage = trace::stage_of(trace::describe_step(recording, id).kind);
        const trace::StepId last = std::min(unit_range_.last, id + stride - 1);
        if (!unit_.empty() && unit_.back().stage == stage) {
            unit_.back().last = last;
        } else {
            unit_.push_back({id, last, stage, std::string{name_of(stage)}});
        }
    }
}

/// Exact steps cost a short re-run each, so that long histories are marked by their triangles.
void TimelineBands::gather_marks(Document& document) {
    constexpr std::size_t most_exact = 24;
    marks_.clear();
    if (!selected_) {
        return;
    }
    const trace::PixelHistory& history = document.history(*selected_);
    const bool exact = history.rows.size() <= most_exact;
    for (const trace::HistoryRow& row : history.rows) {
        marks_.push_back(
            {exact ? trace::last_step_of_fragment(document.recording(), row.fragment)
                   : row.triangle_step,
             row.fate == fragment::FragmentFate::written}
        );
    }
}

void TimelineBands::update(Document& document, const std::optional<PixelPos>& selected) {
    const bool other = document_ != document.revision();
    if (other || selected_ != selected) {
        selected_ = selected;
        gather_marks(document);
    }
    if (other) {
        document_ = document.revision();
        draw_.reset();
        unit_.clear();
        gather_frame(document.recording());
    }
    const std::optional<std::uint32_t> draw = document.current_draw();
    if (draw && draw_ != draw) {
        draw_ = draw;
        gather_unit(document.recording(), *draw);
    } else if (!draw) {
        draw_.reset();
        unit_.clear();
    }
}

} // namespace hs::viewer
