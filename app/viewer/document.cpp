#include "app/viewer/document.hpp"

#include "core/explain/depth_precision.hpp"
#include "core/explain/sentence.hpp"

#include <algorithm>

namespace hs::viewer {
namespace {

PixelRanges pixel_ranges(const trace::Recording& recording) {
    PixelRanges ranges;
    ValueRange depth{2.0F, -1.0F};
    recording.final_pixels.for_each([&](PixelPos, const trace::PixelRecord& pixel) {
        ranges.most_overdraw = std::max(ranges.most_overdraw, pixel.overdraw);
        ranges.most_complexity = std::max(ranges.most_complexity, pixel.complexity);
        if (pixel.triangle != trace::no_triangle) {
            depth.low = std::min(depth.low, pixel.depth);
            depth.high = std::max(depth.high, pixel.depth);
        }
    });
    if (depth.low <= depth.high) {
        ranges.depth = depth;
    }
    return ranges;
}

} // namespace

void Document::show(std::shared_ptr<const trace::Recording> recording) {
    player_ = std::make_unique<trace::Player>(std::move(recording));
    ranges_ = pixel_ranges(player_->recording());
    ++revision_;
    history_.reset();
    fighting_.reset();
    sentence_step_.reset();
    values_step_.reset();
    reasons_of_.reset();
    trail_step_.reset();
    costs_triangle_.reset();
    sweep_step_.reset();
    visibility_outcomes_.clear();
    order_event_.reset();
    order_.reset();
    helpers_piece_.reset();
}

void Document::close() {
    player_.reset();
    ++revision_;
    history_.reset();
    fighting_.reset();
    sentence_step_.reset();
    values_step_.reset();
    reasons_of_.reset();
    trail_step_.reset();
    costs_triangle_.reset();
    sweep_step_.reset();
    visibility_outcomes_.clear();
    order_event_.reset();
    order_.reset();
    helpers_piece_.reset();
}

std::optional<std::uint32_t> Document::current_triangle() const {
    if (!is_open() || !player_->current().in_triangle()) {
        return std::nullopt;
    }
    const trace::Step& step = player_->current();
    return recording().objects[step.object].first_triangle + step.triangle;
}

std::optional<std::uint32_t> Document::current_draw() const {
    const bool drawn = current_triangle() || (is_open() && recording().in_row(player_->step()));
    return drawn ? std::optional{recording().draw_of_step(player_->step())} : std::nullopt;
}

void Document::compare_visibility() {
    HS_CHECK(recording().end_step <= most_steps_to_compare, "a frame that is quickly recorded");
    visibility_outcomes_ = trace::compare_visibility(scene());
}

const trace::SweepDetail* Document::sweep_detail() {
    if (!recording().in_row(player_->step())) {
        return nullptr;
    }
    if (sweep_step_ != player_->step()) {
        sweep_ = trace::sweep_detail(recording(), player_->current());
        sweep_step_ = player_->step();
    }
    return &*sweep_;
}

const trace::OrderDetail* Document::order_detail() {
    const trace::Recording& of = recording();
    const std::size_t decisions = of.decisions.size();
    const bool shown = decisions > 0 && decisions <= most_decisions;
    if (!shown || player_->step() < of.first_order_step) {
        return nullptr;
    }
    const trace::StepId last = std::min(player_->step(), of.first_triangle_step - 1);
    const auto event = static_cast<std::uint32_t>(last - of.first_order_step);
    if (order_event_ != event) {
        order_ = trace::order_detail(of, event);
        order_event_ = event;
    }
    return &*order_;
}

const trace::TriangleDetail* Document::triangle_detail() const {
    if (!current_triangle()) {
        return nullptr;
    }
    const trace::StepDetail& detail = player_->detail();
    return detail.triangle ? &*detail.triangle : nullptr;
}

const trace::PieceDetail* Document::piece_detail() const {
    const trace::TriangleDetail* triangle = triangle_detail();
    if (triangle == nullptr || triangle->pieces.empty()) {
        return nullptr;
    }
    const trace::Step& step = player_->current();
    const auto piece = step.has_piece() ? static_cast<std::size_t>(step.piece) : 0;
    return &triangle->pieces[piece < triangle->pieces.size() ? piece : 0];
}

const trace::VertexDetail* Document::vertex_detail(int corner) const {
    if (player_->current().in_vertex_stage()) {
        const trace::StepDetail& detail = player_->detail();
        return detail.vertex ? &*detail.vertex : nullptr;
    }
    const trace::TriangleDetail* triangle = triangle_detail();
    return triangle == nullptr ? nullptr : &triangle->corners[static_cast<std::size_t>(corner)];
}

const scene::Settings& Document::settings() const {
    const trace::Step& step = player_->current();
    if (step.in_triangle() || step.in_vertex_stage()) {
        return recording().frame->calls()[step.object].settings;
    }
    return recording().settings();
}

const trace::PixelHistory& Document::history(PixelPos pixel) {
    if (!history_ || history_->pixel != pixel) {
        history_ = trace::pixel_history(recording(), pixel);
    }
    return *history_;
}

const std::vector<PixelPos>& Document::fighting_pixels() {
    if (!fighting_) {
        fighting_ = explain::fighting_pixels(recording());
    }
    return *fighting_;
}

const std::vector<explain::StepValue>& Document::values() {
    if (values_step_ != player_->step()) {
        values_ = explain::step_values(recording(), player_->current(), player_->detail());
        values_step_ = player_->step();
    }
    return values_;
}

const Reasons& Document::reasons(PixelPos pixel) {
    const std::pair of{pixel, player_->step()};
    if (reasons_of_ != of) {
        reasons_ = {
            explain::why_this_color(*player_, pixel), explain::triangles_at_pixel(*player_, pixel)};
        reasons_of_ = of;
    }
    return reasons_;
}

const std::string& Document::sentence() {
    if (sentence_step_ != player_->step()) {
        sentence_ = explain::sentence(*player_);
        sentence_step_ = player_->step();
    }
    return sentence_;
}

const std::vector<trace::TraversalCost>& Document::traversal_costs() {
    const std::optional<std::uint32_t> triangle = current_triangle();
    if (!triangle || !player_->current().of_triangle()) {
        traversal_costs_.clear();
    } else if (triangle != costs_triangle_) {
        const trace::Step& step = player_->current();
        traversal_costs_ = trace::compare_traversals(
            recording(), trace::TriangleNumber{step.object, step.triangle}
        );
    }
    costs_triangle_ = triangle;
    return traversal_costs_;
}

const trace::HelperPixels& Document::helper_pixels() {
    const std::optional<std::uint32_t> triangle = current_triangle();
    if (!triangle) {
        helpers_piece_.reset();
        helper_pixels_ = {};
        return helper_pixels_;
    }
    const std::pair piece{*triangle, player_->current().piece};
    if (helpers_piece_ != piece) {
        helper_pixels_ =
            trace::helper_pixels(recording(), *player_->detail().triangle, player_->current());
        helpers_piece_ = piece;
    }
    return helper_pixels_;
}

const trace::Trail& Document::trail() {
    if (trail_step_ != player_->step()) {
        trail_ = trace::trail(recording(), player_->current());
        trail_step_ = player_->step();
    }
    return trail_;
}

} // namespace hs::viewer
