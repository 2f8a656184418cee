#include "app/viewer/search.hpp"

#include <algorithm>
#include <chrono>

namespace hs::viewer {

std::optional<std::string> Search::start(const Document& document, std::string_view expression) {
    const std::shared_ptr<const trace::Recording>& recording = document.player().shared_recording();
    const trace::Player whole(recording); // stands at the end: all of the frame is searched
    Result<search::Query> query = search::Query::prepare(whole, expression);
    if (!query) {
        return query.diagnostics().front().to_string();
    }
    clear();
    recording_ = recording;
    query_.emplace(std::move(*query));
    seen_.assign(
        static_cast<std::size_t>(recording->width()) *
            static_cast<std::size_t>(recording->height()),
        false
    );
    return std::nullopt;
}

double Search::progress() const {
    return query_ && query_->size() > 0
               ? static_cast<double>(next_row_) / static_cast<double>(query_->size())
               : 1.0;
}

/// Asks the next row, and files it if it matches.
void Search::ask_row() {
    const std::size_t row = next_row_++;
    const Result<bool> matched = query_->matches(row);
    if (!matched) {
        problem_ = matched.diagnostics().front().to_string();
        next_row_ = query_->size();
        return;
    }
    if (!*matched) {
        return;
    }
    ++count_;
    if (matches_.size() < most_kept) {
        matches_.push_back(row);
    }
    if (const std::optional<PixelPos> pixel = query_->pixel_of(row)) {
        const std::size_t place =
            static_cast<std::size_t>(pixel->y) * static_cast<std::size_t>(recording_->width()) +
            static_cast<std::size_t>(pixel->x);
        if (!seen_[place]) {
            seen_[place] = true;
            pixels_.push_back(*pixel);
        }
    }
}

/// Rows are in the order of their steps, but for triangles that are not drawn in file order.
void Search::finish() {
    constexpr std::size_t most_marks = 400;
    if (query_->rows() == search::Rows::triangles) {
        std::ranges::stable_sort(matches_, {}, [this](std::size_t row) {
            return query_->step_of(row);
        });
    }
    wanted_marks_ = std::min(most_marks, matches_.size());
    marks_.reserve(wanted_marks_);
}

void Search::add_mark() {
    const std::size_t last = matches_.size() - 1;
    const std::size_t gaps = std::max<std::size_t>(1, wanted_marks_ - 1);
    marks_.push_back(step(marks_.size() * last / gaps));
}

void Search::work(double milliseconds) {
    using Clock = std::chrono::steady_clock;
    constexpr int between_looks = 64;
    const auto until =
        Clock::now() + std::chrono::microseconds(static_cast<long>(milliseconds * 1000.0));
    while (running()) {
        for (int i = 0; i < between_looks && running(); ++i) {
            ask_row();
        }
        if (!running()) {
            finish();
        }
        if (Clock::now() >= until) {
            return;
        }
    }
    while (marks_.size() < wanted_marks_ && Clock::now() < until) {
        add_mark();
    }
}

const trace::Step& Search::address(std::size_t match) {
    const auto known = addresses_.find(match);
    if (known != addresses_.end()) {
        return known->second;
    }
    return addresses_.emplace(match, trace::describe_step(*recording_, step(match))).first->second;
}

std::optional<trace::StepId> Search::find(trace::StepId from, trace::Direction direction) {
    if (!query_) {
        return std::nullopt;
    }
    const bool forward = direction == trace::Direction::forward;
    const auto after = std::partition_point(matches_.begin(), matches_.end(), [&](std::size_t row) {
        const trace::StepId at = query_->step_of(row);
        return forward ? at <= from : at < from;
    });
    if (forward) {
        return after == matches_.end() ? std::nullopt : std::optional{query_->step_of(*after)};
    }
    return after == matches_.begin() ? std::nullopt : std::optional{query_->step_of(*(after - 1))};
}

} // namespace hs::viewer
