#include "core/trace/player.hpp"

#include "core/trace/outline.hpp"
#include "core/trace/tally.hpp"

#include <algorithm>
#include <utility>

namespace hs::trace {
namespace {

/// Costs of moving the framebuffer, in units of applying one logged fragment (measured: about 8
/// ns).
constexpr std::uint64_t undo_cost = 6;         // two dependent look-ups in the log
constexpr std::uint64_t restoring_cost = 8192; // the tiles' list, and copying what is then written

void count_saturating(std::uint16_t& counter) {
    counter = static_cast<std::uint16_t>(counter + (counter < 0xFFFFU ? 1 : 0));
}

/// Exact counts for one pixel among fragments before `done`.
struct PixelCounts {
    std::uint32_t complexity = 0;
    std::uint32_t overdraw = 0;
};

PixelCounts count_pixel(const Recording& recording, PixelPos pixel, std::uint32_t done) {
    PixelCounts counts;
    for (std::uint32_t i = recording.final_pixels[pixel].last_fragment; i != no_fragment;
         i = recording.fragments[i].previous) {
        if (i < done) {
            ++counts.complexity;
            counts.overdraw += recording.fragments[i].written() ? 1U : 0U;
        }
    }
    return counts;
}

/// The smallest rectangle that has both.
void extend(PixelRect& rect, const PixelRect& by) {
    if (rect.empty()) {
        rect = by;
    } else if (!by.empty()) {
        rect.x0 = std::min(rect.x0, by.x0);
        rect.y0 = std::min(rect.y0, by.y0);
        rect.x1 = std::max(rect.x1, by.x1);
        rect.y1 = std::max(rect.y1, by.y1);
    }
}

void extend(PixelRect& rect, PixelPos p) {
    extend(rect, PixelRect{p.x, p.y, p.x + 1, p.y + 1});
}

std::uint16_t saturated(std::uint32_t count) {
    return static_cast<std::uint16_t>(std::min<std::uint32_t>(count, 0xFFFFU));
}

} // namespace

Player::Player(std::shared_ptr<const Recording> recording)
    : recording_(std::move(recording)),
      cleared_(recording_->settings()),
      buffer_(recording_->final_pixels),
      fragments_done_(static_cast<std::uint32_t>(recording_->fragments.size())),
      changed_(recording_->settings().image()) {
    current_ = describe_step(*recording_, recording_->end_step);
}

void Player::seek(StepId step) {
    const StepId goal = std::min(step, end());
    detail_.reset();
    if (goal == 0 || goal < recording_->first_triangle_step) {
        current_ = describe_step(*recording_, goal);
        show_fragments(0);
        return;
    }
    if (goal >= recording_->first_resolve_step) {
        current_ = describe_step(*recording_, goal);
        show_fragments(static_cast<std::uint32_t>(recording_->fragments.size()));
        return;
    }
    const std::size_t entry = index_entry_of_step(*recording_, goal);
    const Outline window = outline(*recording_, entry);
    const std::size_t at = goal - window.first_step;
    current_ = window.steps[at];

    // Fragments done: those that began up to here, less the current one while steps of it are still
    // to come
    std::uint32_t done = recording_->index[entry].fragment;
    for (std::size_t i = 0; i <= at; ++i) {
        done += window.steps[i].kind == StepKind::interpolate ? 1U : 0U;
    }
    const bool more_to_come = current_.in_fragment() && at + 1 < window.steps.size() &&
                              window.steps[at + 1].in_fragment() &&
                              window.steps[at + 1].fragment == current_.fragment;
    show_fragments(more_to_come ? done - 1 : done);
}

bool Player::advance(Granularity granularity, Direction direction) {
    const StepId goal = target(granularity, direction);
    const bool moved = goal != step();
    seek(goal);
    return moved;
}

std::uint32_t Player::complexity(PixelPos p) const {
    const std::uint16_t kept = pixel(p).complexity;
    return kept < 0xFFFFU ? kept : count_pixel(*recording_, p, fragments_done_).complexity;
}

std::uint32_t Player::overdraw(PixelPos p) const {
    const std::uint16_t kept = pixel(p).overdraw;
    return kept < 0xFFFFU ? kept : count_pixel(*recording_, p, fragments_done_).overdraw;
}

bool Player::resolved(PixelPos p) const {
    const auto number = static_cast<StepId>(p.y) * static_cast<StepId>(recording_->width()) +
                        static_cast<StepId>(p.x);
    return recording_->samples.active() && step() >= recording_->first_resolve_step + number;
}

PixelRect Player::take_changed() {
    return std::exchange(changed_, PixelRect{});
}

Counters Player::counters() const {
    if (step() >= recording_->first_resolve_step) {
        return recording_->counters;
    }
    Counters counters;
    if (step() < recording_->first_triangle_step) {
        for (const ObjectRange& object : recording_->objects) {
            if (step() < object.first_vertex_step) {
                break;
            }
            const auto per_vertex = static_cast<StepId>(object.steps_per_vertex);
            const StepId begun = (step() - object.first_vertex_step) / per_vertex + 1;
            counters.vertices += std::min<StepId>(begun, object.vertex_count);
        }
        const StepId decided = step() + 1 - std::min(step() + 1, recording_->first_order_step);
        counters.decisions = recording_->decisions.counts_before(decided);
        return counters;
    }
    const std::size_t entry = index_entry_of_step(*recording_, step());
    counters = recording_->index[entry].before;
    const Outline window = outline(*recording_, entry);
    StepKind previous = StepKind::start;
    for (const Step& s : window.steps) {
        if (s.id > step()) {
            break;
        }
        count_cost(counters, window.costs[s.id - window.first_step]);
        const bool first = s.kind == StepKind::clip_plane ? previous == StepKind::outcodes
                                                          : previous != StepKind::scissor_test &&
                                                                previous != StepKind::closed_test &&
                                                                previous != StepKind::depth_test;
        count_step(counters, s.kind, !s.fatal, first);
        if (s.kind == StepKind::sweep) {
            ++counters.sweeps[static_cast<std::size_t>(s.sweep)];
        }
        previous = s.kind;
    }
    return counters;
}

const StepDetail& Player::detail() const {
    if (!detail_) {
        detail_ = step_detail(*recording_, current_);
    }
    return *detail_;
}

/// Redoes logged fragments in order. The log is read in sequence but pixels are met all over the
/// image: asking for a pixel some fragments ahead hides most of the waiting for memory.
void Player::apply_until(std::uint32_t fragments) {
    if (fragments_done_ >= fragments) {
        return;
    }
    constexpr std::uint32_t ahead = 24;
    const std::vector<Run>& runs = recording_->runs;
    auto run =
        static_cast<std::size_t>(&recording_->run_of_fragment(fragments_done_) - runs.data());
    PixelRect changed = changed_;
    for (; fragments_done_ < fragments; ++fragments_done_) {
        if (fragments_done_ + ahead < fragments) {
            const PixelPos coming = recording_->fragments[fragments_done_ + ahead].pixel();
            __builtin_prefetch(&buffer_[coming], 1);
        }
        while (run + 1 < runs.size() && runs[run + 1].first_fragment <= fragments_done_) {
            ++run;
        }
        const FragmentRecord& f = recording_->fragments[fragments_done_];
        apply(f, runs[run].triangle);
        extend(changed, f.pixel());
    }
    changed_ = changed;
}

void Player::apply(const FragmentRecord& f, std::uint32_t triangle) {
    PixelRecord& pixel = buffer_.writable(f.pixel());
    pixel.last_fragment = fragments_done_;
    count_saturating(pixel.complexity);
    if (f.written()) {
        count_saturating(pixel.overdraw);
        pixel.color = f.color;
        pixel.triangle = triangle;
        if (buffer_.float_color()) {
            buffer_.set_color32f(f.pixel(), recording_->color32f[fragments_done_]);
        }
    }
    if (f.depth_written) {
        pixel.depth = f.depth;
    }
}

/// Takes logged fragments back, last first: a pixel returns to what its earlier fragments made it.
void Player::undo_until(std::uint32_t fragments) {
    while (fragments_done_ > fragments) {
        --fragments_done_;
        const FragmentRecord& f = recording_->fragments[fragments_done_];
        PixelRecord& pixel = buffer_.writable(f.pixel());
        pixel.last_fragment = f.previous;
        if (pixel.complexity == 0xFFFFU || pixel.overdraw == 0xFFFFU) {
            const PixelCounts counts = count_pixel(*recording_, f.pixel(), fragments_done_);
            pixel.complexity = saturated(counts.complexity);
            pixel.overdraw = saturated(counts.overdraw);
        } else {
            --pixel.complexity;
            pixel.overdraw = static_cast<std::uint16_t>(pixel.overdraw - (f.written() ? 1 : 0));
        }
        if (f.written() || f.depth_written) {
            const PixelBefore before = pixel_before(*recording_, fragments_done_);
            pixel.color = framebuffer::pack(before.color);
            pixel.depth = before.depth;
            pixel.triangle = before.triangle;
            if (buffer_.float_color()) {
                buffer_.set_color32f(f.pixel(), before.color);
            }
        }
        extend(changed_, f.pixel());
    }
}

void Player::restore(PixelBuffer buffer, std::uint32_t fragments) {
    extend(changed_, buffer_.difference(buffer));
    buffer_ = std::move(buffer);
    fragments_done_ = fragments;
}

/// Moves the framebuffer to the state after `fragments` fragments by the cheapest way: on from
/// here, back from here, or from a framebuffer that was kept: the cleared one, the nearest
/// checkpoint below, or the finished one.
void Player::show_fragments(std::uint32_t fragments) {
    const auto all = static_cast<std::uint32_t>(recording_->fragments.size());
    const auto cost = [fragments](std::uint32_t from) {
        return fragments >= from ? std::uint64_t{fragments - from}
                                 : undo_cost * std::uint64_t{from - fragments};
    };
    const std::vector<Checkpoint>& checkpoints = recording_->checkpoints;
    const auto above = std::upper_bound(
        checkpoints.begin(),
        checkpoints.end(),
        fragments,
        [](std::uint32_t f, const Checkpoint& c) { return f < c.fragments; }
    );
    const PixelBuffer* base = above == checkpoints.begin() ? &cleared_ : &(above - 1)->buffer;
    std::uint32_t base_fragments = above == checkpoints.begin() ? 0 : (above - 1)->fragments;
    if (cost(all) < cost(base_fragments)) {
        base = &recording_->final_pixels;
        base_fragments = all;
    }
    if (restoring_cost + cost(base_fragments) < cost(fragments_done_)) {
        restore(*base, base_fragments);
    }
    if (fragments >= fragments_done_) {
        apply_until(fragments);
    } else {
        undo_until(fragments);
    }
}

} // namespace hs::trace
