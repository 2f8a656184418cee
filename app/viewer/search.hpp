// A search through the open recording: what matches, found in slices between the window's frames.
#pragma once

#include "app/viewer/document.hpp"
#include "core/search/query.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace hs::viewer {

class Search {
public:
    /// More matches are counted, but not kept.
    static constexpr std::size_t most_kept = 1'000'000;

    /// Begins a search through the whole frame. What is wrong with the expression, or nothing.
    /// Precondition: the document is open.
    std::optional<std::string> start(const Document& document, std::string_view expression);
    void clear() { *this = Search{}; }
    /// Goes on for about so long; does nothing once all rows were asked.
    void work(double milliseconds);

    [[nodiscard]] bool begun() const { return query_.has_value(); }
    /// There is a search, and it is of this document's recording.
    [[nodiscard]] bool is_of(const Document& document) const {
        return query_.has_value() && recording_ == document.player().shared_recording();
    }
    [[nodiscard]] bool running() const { return query_.has_value() && next_row_ < query_->size(); }
    /// The part of all rows that were asked, in [0, 1].
    [[nodiscard]] double progress() const;
    /// Why it ended early, in one sentence; else empty.
    [[nodiscard]] const std::string& problem() const { return problem_; }
    [[nodiscard]] search::Rows rows() const { return query_->rows(); }
    [[nodiscard]] std::size_t size() const { return query_->size(); } ///< how many rows there are

    [[nodiscard]] std::size_t count() const { return count_; }
    /// By step. Matches found so far while running.
    [[nodiscard]] std::size_t kept() const { return matches_.size(); }
    /// Where a match stands. Precondition: match < kept().
    [[nodiscard]] const trace::Step& address(std::size_t match);
    /// The nearest match after a step, or before it.
    [[nodiscard]] std::optional<trace::StepId> find(trace::StepId from, trace::Direction direction);

    /// Pixels with a matching fragment or step, each once.
    [[nodiscard]] const std::vector<PixelPos>& pixels() const { return pixels_; }
    /// Steps of some matches, spread evenly: all of them where they are few.
    [[nodiscard]] const std::vector<trace::StepId>& marks() const { return marks_; }

private:
    void ask_row();
    void finish();
    void add_mark();
    [[nodiscard]] trace::StepId step(std::size_t match) const {
        return query_->step_of(matches_[match]);
    }

    std::shared_ptr<const trace::Recording> recording_;
    std::optional<search::Query> query_;
    std::size_t next_row_ = 0;
    std::size_t count_ = 0;
    std::vector<std::size_t> matches_; ///< rows
    std::vector<bool> seen_;           ///< by pixel: already among `pixels_`
    std::vector<PixelPos> pixels_;
    std::vector<trace::StepId> marks_;
    std::size_t wanted_marks_ = 0; ///< once all rows were asked
    std::unordered_map<std::size_t, trace::Step> addresses_;
    std::string problem_;
};

} // namespace hs::viewer
