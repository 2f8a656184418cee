// Where a press of a key goes: the next and previous unit end of every granularity.
//
// Each granularity has a sequence of unit ends; forward is the first one after the playhead,
// backward the last one before it, so forward and back reverse each other. `start` and `end` belong
// to every sequence.
#include "core/trace/outline.hpp"
#include "core/trace/player.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

namespace hs::trace {
namespace {

/// The nearest of a few steps in a direction; `fallback` when none lies there.
class Nearest {
public:
    Nearest(StepId from, Direction direction, StepId fallback)
        : from_(from), forward_(direction == Direction::forward), best_(fallback) {}

    void offer(StepId step) {
        const bool ahead = forward_ ? step > from_ : step < from_;
        if (ahead && (forward_ ? step < best_ : step > best_)) {
            best_ = step;
        }
    }
    [[nodiscard]] StepId best() const { return best_; }

private:
    StepId from_;
    bool forward_;
    StepId best_;
};

StepId fallback(const Recording& recording, Direction direction) {
    return direction == Direction::forward ? recording.end_step : 0;
}

StepId stage_target(const Recording& recording, StepId from, Direction direction) {
    Nearest nearest(from, direction, fallback(recording, direction));
    nearest.offer(recording.first_order_step - 1);
    nearest.offer(recording.first_triangle_step - 1);
    nearest.offer(recording.first_sweep_step - 1);
    nearest.offer(recording.first_resolve_step - 1);
    nearest.offer(recording.end_step - 1);
    return nearest.best();
}

StepId object_target(const Recording& recording, StepId from, Direction direction) {
    Nearest nearest(from, direction, fallback(recording, direction));
    nearest.offer(recording.first_triangle_step - 1);
    for (const ObjectRange& object : recording.objects) {
        if (object.vertex_count > 0) {
            nearest.offer(
                object.first_vertex_step +
                StepId{object.vertex_count} * static_cast<StepId>(object.steps_per_vertex) - 1
            );
        }
        if (object.triangle_count > 0) {
            nearest.offer(last_step_of_draw(recording, object.last_draw));
        }
    }
    nearest.offer(recording.first_resolve_step - 1);
    return nearest.best();
}

/// The last step of the vertex before, at and after a step of the vertex stage.
void offer_vertices(const Recording& recording, StepId from, Nearest& nearest) {
    for (const ObjectRange& object : recording.objects) {
        if (object.vertex_count == 0) {
            continue;
        }
        const auto steps = static_cast<StepId>(object.steps_per_vertex);
        const StepId first_end = object.first_vertex_step + steps - 1;
        const StepId last_end = first_end + (StepId{object.vertex_count} - 1) * steps;
        const StepId inside = std::clamp(from, first_end, last_end);
        const StepId end = first_end + (inside - first_end) / steps * steps;
        nearest.offer(std::max(first_end, end - std::min(end - first_end, steps)));
        nearest.offer(end);
        nearest.offer(std::min(last_end, end + steps));
    }
}

/// The decisions of a kind before and after a step.
void offer_decisions(
    const Recording& recording, StepId from, visibility::OrderEventKind kind, Nearest& nearest
) {
    const StepId inside =
        std::clamp(from, recording.first_order_step, recording.first_triangle_step);
    const OrderCounts before =
        recording.decisions.counts_before(inside - recording.first_order_step);
    const std::uint64_t ordinal = before[static_cast<std::size_t>(kind)];
    for (std::uint64_t i = ordinal - std::min<std::uint64_t>(ordinal, 1); i <= ordinal + 1; ++i) {
        if (const std::optional<std::size_t> found = recording.decisions.find(kind, i)) {
            nearest.offer(recording.first_order_step + *found);
        }
    }
}

/// The last step of the draws before, at and after a step, from draw `first` on.
void offer_draws(const Recording& recording, StepId from, std::int64_t first, Nearest& nearest) {
    const std::vector<StepId>& draws = recording.draw_steps;
    const std::int64_t index = std::upper_bound(draws.begin(), draws.end(), from) - draws.begin();
    for (std::int64_t d = std::max(index - 2, first); d <= std::max(index, first); ++d) {
        if (d < static_cast<std::int64_t>(draws.size())) {
            nearest.offer(last_step_of_draw(recording, static_cast<std::uint32_t>(d)));
        }
    }
}

StepId triangle_target(const Recording& recording, StepId from, Direction direction) {
    Nearest nearest(from, direction, fallback(recording, direction));
    offer_vertices(recording, from, nearest);
    offer_decisions(recording, from, visibility::OrderEventKind::emit, nearest);
    offer_draws(recording, from, 0, nearest);
    return nearest.best();
}

bool same_unit(const Step& a, const Step& b) {
    return a.in_unit() && b.in_unit() && a.object == b.object && a.triangle == b.triangle &&
           a.piece == b.piece && a.unit == b.unit;
}

/// Offers the last step of every unit of triangles' traversals in one
/// stretch. Stretches never end inside a unit.
void offer_units(const Recording& recording, const Outline& window, Nearest& nearest) {
    for (std::size_t i = 0; i < window.steps.size(); ++i) {
        const bool ends =
            i + 1 == window.steps.size() || !same_unit(window.steps[i], window.steps[i + 1]);
        if (window.steps[i].in_unit() && ends && !recording.in_row(window.steps[i].id)) {
            nearest.offer(window.steps[i].id);
        }
    }
}

/// Offers the last step of every ray. Stretches never end inside one.
void offer_rays(const Recording& recording, const Outline& window, Nearest& nearest) {
    for (std::size_t i = 0; i < window.steps.size(); ++i) {
        const bool ends =
            i + 1 == window.steps.size() || window.steps[i].pixel != window.steps[i + 1].pixel;
        if (ends && recording.in_row(window.steps[i].id)) {
            nearest.offer(window.steps[i].id);
        }
    }
}

/// The count of something at the beginning of each index entry; the frame's total beyond the last.
template <typename Count>
std::uint64_t count_at(const Recording& recording, std::size_t entry, Count count) {
    return count(
        entry < recording.index.size() ? recording.index[entry].before : recording.counters
    );
}

/// The nearest index entry, from `entry` on in a direction, whose stretch counts something. Binary
/// search: counts only grow. Returns index.size() when there is none.
template <typename Count>
std::size_t
entry_with(const Recording& recording, std::size_t entry, Direction direction, Count count) {
    const std::size_t entries = recording.index.size();
    std::size_t low = direction == Direction::forward ? entry : 0;
    std::size_t high = direction == Direction::forward ? entries : entry + 1;
    if (direction == Direction::forward) {
        // The first stretch after which the count has grown beyond its value at `entry`
        const std::uint64_t base = count_at(recording, entry, count);
        while (low < high) {
            const std::size_t middle = low + (high - low) / 2;
            (count_at(recording, middle + 1, count) > base ? high : low) =
                count_at(recording, middle + 1, count) > base ? middle : middle + 1;
        }
        return low;
    }
    // The last stretch before which the count was still below its value after `entry`
    const std::uint64_t top = count_at(recording, entry + 1, count);
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (count_at(recording, middle, count) < top) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low == 0 ? entries : low - 1;
}

/// Searches stretch by stretch, skipping those that count nothing, until one offers a step. At most
/// three are re-run: the one the playhead is in, and up to two that have something.
template <typename Count, typename Offer>
StepId search_stretches(
    const Recording& recording,
    StepId from,
    Direction direction,
    StepId none,
    Count count,
    Offer offer
) {
    const std::size_t entries = recording.index.size();
    if (entries == 0 || recording.first_triangle_step == recording.first_resolve_step) {
        return none;
    }
    const bool forward = direction == Direction::forward;
    if (!forward && from <= recording.first_triangle_step) {
        return none;
    }
    const StepId inside =
        std::clamp(from, recording.first_triangle_step, recording.first_resolve_step - 1);
    std::size_t entry = index_entry_of_step(recording, inside);
    while (true) {
        entry = entry_with(recording, entry, direction, count);
        if (entry >= entries) {
            return none;
        }
        Nearest nearest(from, direction, none);
        offer(outline(recording, entry), nearest);
        if (nearest.best() != none) {
            return nearest.best();
        }
        if (forward ? entry + 1 >= entries : entry == 0) {
            return none;
        }
        entry = forward ? entry + 1 : entry - 1;
    }
}

/// Grows with every step of a traversal.
std::uint64_t traversed(const Counters& counters) {
    return counters.traversal.pixels + counters.traversal.tiles + counters.scan_steps;
}

/// The end of a unit of a traversal or of a row of the image, or the beginning of an iteration of
/// an ordering.
StepId unit_target(const Recording& recording, StepId from, Direction direction) {
    const StepId none = fallback(recording, direction);
    Nearest nearest(from, direction, none);
    offer_decisions(recording, from, visibility::OrderEventKind::iteration, nearest);
    offer_draws(recording, from, recording.first_row_draw(), nearest);
    nearest.offer(search_stretches(
        recording,
        from,
        direction,
        none,
        traversed,
        [&recording](const Outline& window, Nearest& found) {
            offer_units(recording, window, found);
        }
    ));
    return nearest.best();
}

/// The end of a ray.
StepId pixel_target(const Recording& recording, StepId from, Direction direction) {
    return search_stretches(
        recording,
        from,
        direction,
        fallback(recording, direction),
        [](const Counters& counters) {
            return counters.sweeps[static_cast<std::size_t>(visibility::SweepEventKind::cast)];
        },
        [&recording](const Outline& window, Nearest& nearest) {
            offer_rays(recording, window, nearest);
        }
    );
}

StepId fragment_target(const Player& player, Direction direction) {
    const Recording& recording = player.recording();
    if (recording.settings().visibility == scene::Visibility::ray_cast) {
        return pixel_target(recording, player.step(), direction);
    }
    const std::uint32_t done = player.fragments_done();
    if (direction == Direction::forward) {
        return done < recording.fragments.size() ? last_step_of_fragment(recording, done)
                                                 : recording.end_step;
    }
    if (done == 0) {
        return 0;
    }
    const StepId last = last_step_of_fragment(recording, done - 1);
    if (last < player.step()) {
        return last;
    }
    return done == 1 ? 0 : last_step_of_fragment(recording, done - 2);
}

/// The nearest step within [first, last), for stages that come as a whole.
std::optional<StepId> step_within(StepId first, StepId last, StepId from, Direction direction) {
    const bool forward = direction == Direction::forward;
    if (forward ? from + 1 >= last : from <= first) {
        return std::nullopt;
    }
    const StepId goal = forward ? std::max(from + 1, first) : std::min(from, last) - 1;
    return goal >= first && goal < last ? std::optional{goal} : std::nullopt;
}

std::uint64_t stage_count_of(const Counters& counters, Stage stage) {
    switch (stage) {
    case Stage::application:
    case Stage::vertex: return counters.vertices; // found by its range of steps
    case Stage::visibility:
        return std::accumulate(
            counters.sweeps.begin(), counters.sweeps.end(), std::uint64_t{0}
        ); // decisions about order are found by their range
    case Stage::clip: return counters.triangles;
    case Stage::divide: return counters.pieces;
    case Stage::viewport: return counters.pieces_mapped;
    case Stage::cull: return counters.pieces_faced;
    case Stage::setup: return counters.pieces_set_up;
    case Stage::traverse: return traversed(counters);
    case Stage::shade: return counters.fragments_shaded;
    case Stage::test: return counters.fragments_tested;
    case Stage::merge:
        return counters.fates[static_cast<std::size_t>(fragment::FragmentFate::written)];
    }
    HS_CHECK(false, "every stage counts something");
    return 0;
}

/// Resolving belongs to the stage that merges: the nearer of a merge that was found and the
/// resolves, which come after all of them.
std::optional<StepId> nearest_resolve(
    const Recording& recording, StepId from, Direction direction, std::optional<StepId> merge
) {
    const StepId first = recording.first_resolve_step;
    const StepId last = recording.end_step - 1;
    if (direction == Direction::forward) {
        const StepId next = std::max(from + 1, first);
        return merge || next > last ? merge : next;
    }
    return from > first ? std::min(from - 1, last) : merge;
}

} // namespace

StepId Player::target(Granularity granularity, Direction direction) const {
    const Recording& recording = *recording_;
    switch (granularity) {
    case Granularity::stage: return stage_target(recording, step(), direction);
    case Granularity::object: return object_target(recording, step(), direction);
    case Granularity::triangle: return triangle_target(recording, step(), direction);
    case Granularity::scanline: return unit_target(recording, step(), direction);
    case Granularity::fragment: return fragment_target(*this, direction);
    case Granularity::operation:
        if (direction == Direction::forward) {
            return std::min(step() + 1, end());
        }
        return step() == 0 ? 0 : step() - 1;
    }
    HS_CHECK(false, "every granularity has targets");
    return step();
}

std::optional<StepId> Player::find_stage(Stage stage, Direction direction) const {
    const bool forward = direction == Direction::forward;
    if (stage == Stage::application) {
        return forward || step() == 0 ? std::nullopt : std::optional<StepId>{0};
    }
    if (stage == Stage::vertex) {
        return step_within(1, recording_->first_order_step, step(), direction);
    }
    if (stage == Stage::visibility && !recording_->settings().sweeps()) {
        return step_within(
            recording_->first_order_step, recording_->first_triangle_step, step(), direction
        );
    }
    const StepId none = fallback(*recording_, direction);
    const StepId found = search_stretches(
        *recording_,
        step(),
        direction,
        none,
        [stage](const Counters& counters) { return stage_count_of(counters, stage); },
        [stage](const Outline& window, Nearest& nearest) {
            for (const Step& s : window.steps) {
                if (stage_of(s.kind) == stage) {
                    nearest.offer(s.id);
                }
            }
        }
    );
    const auto reached = found == none ? std::nullopt : std::optional<StepId>{found};
    if (stage == Stage::merge && recording_->samples.active()) {
        return nearest_resolve(*recording_, step(), direction, reached);
    }
    return reached;
}

} // namespace hs::trace
