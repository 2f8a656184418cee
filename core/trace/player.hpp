// The player: stands on a step of a recording and shows the framebuffer there, however it arrived.
//
// Framebuffer at a step = nearest checkpoint + logged fragments, forward; backward, fragments are
// undone through the links to their predecessors. Both are exact, so any step equals a fresh run
// stopped there.
#pragma once

#include "core/trace/detail.hpp"
#include "core/trace/recording.hpp"
#include "core/trace/step.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace hs::trace {

enum class Direction : std::uint8_t {
    forward,
    backward
};

class Player {
public:
    /// Stands on `end`: the finished picture.
    explicit Player(std::shared_ptr<const Recording> recording);

    [[nodiscard]] const Recording& recording() const { return *recording_; }
    [[nodiscard]] const std::shared_ptr<const Recording>& shared_recording() const {
        return recording_;
    }
    [[nodiscard]] StepId step() const { return current_.id; }
    [[nodiscard]] StepId end() const { return recording_->end_step; }

    /// Where the playhead stands.
    [[nodiscard]] const Step& current() const { return current_; }

    /// Goes to a step; beyond the end is the end.
    void seek(StepId step);

    /// Goes to the next or previous place of a granularity: forward to the end of the current unit,
    /// or of the next one when already there; backward to the end of the previous unit. False when
    /// there is none; the playhead then stays at `end` or goes to `start`. Forward and back reverse
    /// each other between unit ends.
    bool advance(Granularity granularity, Direction direction);

    /// The step `advance` would go to.
    [[nodiscard]] StepId target(Granularity granularity, Direction direction) const;

    /// The nearest later (earlier) step of a pipeline stage, for clicks on the strip. Empty when
    /// there is none.
    [[nodiscard]] std::optional<StepId> find_stage(Stage stage, Direction direction) const;

    /// Pixels after the current step.
    [[nodiscard]] const PixelRecord& pixel(PixelPos p) const { return buffer_[p]; }
    [[nodiscard]] glm::vec4 color(PixelPos p) const { return buffer_.color(p); }
    /// Frames with several samples a pixel: what its samples hold. Pixels show what these resolve
    /// to, whether they have been resolved yet or not.
    [[nodiscard]] framebuffer::PixelSamples samples(PixelPos p) const {
        return recording_->samples.after(pixel(p).last_fragment);
    }
    /// Whether the step that resolves the pixel lies behind.
    [[nodiscard]] bool resolved(PixelPos p) const;
    /// Fragments that have met their fate at the current step.
    [[nodiscard]] std::uint32_t fragments_done() const { return fragments_done_; }
    /// Exact numbers of fragments generated and written at a pixel up to the current step, beyond
    /// what 16 bits hold.
    [[nodiscard]] std::uint32_t complexity(PixelPos p) const;
    [[nodiscard]] std::uint32_t overdraw(PixelPos p) const;

    /// The pixels that may have changed since the last call, so that pictures are updated where
    /// they must be.
    [[nodiscard]] PixelRect take_changed();

    /// What has happened up to and including the current step.
    [[nodiscard]] Counters counters() const;

    /// The reasoning behind the current step; computed on first use, kept until the playhead moves.
    [[nodiscard]] const StepDetail& detail() const;

private:
    void apply_until(std::uint32_t fragments);
    void undo_until(std::uint32_t fragments);
    void restore(PixelBuffer buffer, std::uint32_t fragments);
    void show_fragments(std::uint32_t fragments);
    void apply(const FragmentRecord& fragment, std::uint32_t triangle);

    std::shared_ptr<const Recording> recording_;
    Step current_;
    PixelBuffer cleared_; ///< before the first fragment
    PixelBuffer buffer_;
    std::uint32_t fragments_done_ = 0;
    PixelRect changed_;
    mutable std::optional<StepDetail> detail_;
};

/// The address of a flat step number. Precondition: step <= recording.end_step.
Step describe_step(const Recording& recording, StepId step);

/// The step a fragment ends with.
StepId last_step_of_fragment(const Recording& recording, std::uint32_t fragment);

/// The last step of a triangle (frame-wide number); of a split one, of its part drawn last.
StepId last_step_of_triangle(const Recording& recording, std::uint32_t triangle);

/// The last step of something in the order of draws.
StepId last_step_of_draw(const Recording& recording, std::uint32_t draw);

/// Finds the step a written path names: `#184467`, `start`, `end`, or words and numbers in any
/// order. A path that stops early means "after its last child". Errors say which part does not
/// exist and what would.
Result<StepId> find_step(const Recording& recording, std::string_view path);

} // namespace hs::trace
