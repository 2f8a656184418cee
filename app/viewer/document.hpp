// What is open: a recorded frame with a playhead on it, and what is cached about it.
#pragma once

#include "app/viewer/screen_colors.hpp"
#include "core/explain/why_color.hpp"
#include "core/explain/why_not.hpp"
#include "core/trace/comparison.hpp"
#include "core/trace/history.hpp"
#include "core/trace/order_detail.hpp"
#include "core/trace/player.hpp"
#include "core/trace/quad_detail.hpp"
#include "core/trace/sweep_detail.hpp"
#include "core/trace/trail.hpp"
#include "core/trace/visibility_comparison.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hs::viewer {

/// What the pixels of the finished frame span, so that colors keep their meaning while stepping.
struct PixelRanges {
    ValueRange depth; ///< of what was drawn
    std::uint16_t most_overdraw = 1;
    std::uint16_t most_complexity = 1;
};

/// Why a pixel has its color, and why other triangles do not show there.
struct Reasons {
    std::vector<explain::ColorLink> color;
    std::vector<explain::TriangleAtPixel> triangles;
};

class Document {
public:
    /// Puts the playhead on the end of another recording.
    void show(std::shared_ptr<const trace::Recording> recording);
    void close();

    [[nodiscard]] bool is_open() const { return player_ != nullptr; }
    /// Precondition for all below: is_open().
    [[nodiscard]] trace::Player& player() { return *player_; }
    [[nodiscard]] const trace::Player& player() const { return *player_; }
    [[nodiscard]] const trace::Recording& recording() const { return player_->recording(); }
    [[nodiscard]] const scene::Scene& scene() const { return recording().scene(); }

    /// Grows with every recording shown, so that caches know when they are stale.
    [[nodiscard]] unsigned revision() const { return revision_; }

    [[nodiscard]] const PixelRanges& ranges() const { return ranges_; }

    /// The triangle the current step belongs to, over the whole frame.
    [[nodiscard]] std::optional<std::uint32_t> current_triangle() const;
    /// Where the current step stands in the order of draws.
    [[nodiscard]] std::optional<std::uint32_t> current_draw() const;
    /// Its reasoning, or null.
    [[nodiscard]] const trace::TriangleDetail* triangle_detail() const;
    /// The piece the current step belongs to, or the first; null where there is none.
    [[nodiscard]] const trace::PieceDetail* piece_detail() const;
    /// The vertex the current step is about, or a corner of its triangle; null where there is none.
    [[nodiscard]] const trace::VertexDetail* vertex_detail(int corner) const;
    /// The settings of the current step's object; the frame's outside of objects.
    [[nodiscard]] const scene::Settings& settings() const;

    /// Decisions up to which the state around each is shown: a run takes a tenth of a second then.
    static constexpr std::size_t most_decisions = 300'000;
    /// What the ordering algorithm knows: after its current decision, later at its end; null before
    /// it, where triangles are drawn in file order, and where there are more decisions than that.
    const trace::OrderDetail* order_detail();

    /// Steps of a frame up to which every visible-surface algorithm is tried on it here: that takes
    /// a second or two.
    static constexpr trace::StepId most_steps_to_compare = 1'000'000;
    /// What every visible-surface algorithm makes of the scene: nothing until it has been asked
    /// for.
    [[nodiscard]] const std::vector<trace::VisibilityOutcome>& visibility_outcomes() const {
        return visibility_outcomes_;
    }
    /// Precondition: the frame has no more steps than that.
    void compare_visibility();

    /// What the current scanline or ray knows; null outside of rows that are drawn as a whole.
    const trace::SweepDetail* sweep_detail();

    /// The whole history of a pixel, kept until another pixel is asked for.
    const trace::PixelHistory& history(PixelPos pixel);

    /// Where rounding of depth decides who is seen; found on first use.
    const std::vector<PixelPos>& fighting_pixels();

    /// The sentence about the current step, kept until the playhead moves.
    const std::string& sentence();

    /// The values of the current step, kept until the playhead moves.
    const std::vector<explain::StepValue>& values();

    /// Kept until another pixel is asked for or the playhead moves.
    const Reasons& reasons(PixelPos pixel);

    /// What every traversal would spend on the current triangle, kept until another one is
    /// current; empty outside of triangles.
    const std::vector<trace::TraversalCost>& traversal_costs();

    /// What the current triangle's traversal has done so far, kept until the playhead moves.
    const trace::Trail& trail();

    /// The pixels shaded only to help the current piece's derivatives, kept until another piece is
    /// current; none outside of pieces.
    const trace::HelperPixels& helper_pixels();

private:
    std::unique_ptr<trace::Player> player_;
    unsigned revision_ = 0;
    PixelRanges ranges_;
    std::optional<trace::PixelHistory> history_;
    std::optional<std::vector<PixelPos>> fighting_;
    std::optional<trace::OrderDetail> order_;
    std::optional<std::uint32_t> order_event_;
    std::vector<trace::VisibilityOutcome> visibility_outcomes_;
    std::optional<trace::SweepDetail> sweep_;
    std::optional<trace::StepId> sweep_step_;
    std::string sentence_;
    std::optional<trace::StepId> sentence_step_;
    std::vector<explain::StepValue> values_;
    std::optional<trace::StepId> values_step_;
    Reasons reasons_;
    std::optional<std::pair<PixelPos, trace::StepId>> reasons_of_;
    std::vector<trace::TraversalCost> traversal_costs_;
    std::optional<std::uint32_t> costs_triangle_;
    trace::Trail trail_;
    std::optional<trace::StepId> trail_step_;
    trace::HelperPixels helper_pixels_;
    std::optional<std::pair<std::uint32_t, std::int32_t>> helpers_piece_; ///< triangle, piece
};

} // namespace hs::viewer
