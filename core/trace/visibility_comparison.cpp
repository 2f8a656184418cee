#include "core/trace/visibility_comparison.hpp"

#include <numeric>

namespace hs::trace {
namespace {

Result<std::shared_ptr<const Recording>>
record_with(const scene::Scene& scene, scene::Visibility visibility) {
    auto variant = std::make_shared<scene::Scene>(scene);
    variant->settings.visibility = visibility;
    if (const auto problem = scene::check_combination(variant->settings)) {
        return Diagnostic{.message = *problem};
    }
    return record(variant);
}

/// Whether a decision holds two things against each other; the rest move and mark.
bool is_question(visibility::OrderEventKind kind) {
    using visibility::OrderEventKind;
    switch (kind) {
    case OrderEventKind::compare:
    case OrderEventKind::overlap:
    case OrderEventKind::nearer:
    case OrderEventKind::test:
    case OrderEventKind::exchanged_test:
    case OrderEventKind::classify:
    case OrderEventKind::enter_node:
    case OrderEventKind::in_front: return true;
    case OrderEventKind::move:
    case OrderEventKind::emit:
    case OrderEventKind::list_in_front:
    case OrderEventKind::iteration:
    case OrderEventKind::count_down:
    case OrderEventKind::stuck:
    case OrderEventKind::take_farthest:
    case OrderEventKind::draw_anyway:
    case OrderEventKind::split:
    case OrderEventKind::candidate: // its questions are not told one by one
    case OrderEventKind::make_node:
    case OrderEventKind::visit_side:
    case OrderEventKind::make_cell:
    case OrderEventKind::enter_cell:
    case OrderEventKind::undecided: return false;
    }
    HS_CHECK(false, "every kind is handled");
    return false;
}

bool is_question(visibility::SweepEventKind kind) {
    using visibility::SweepEventKind;
    return kind == SweepEventKind::compare || kind == SweepEventKind::depth ||
           kind == SweepEventKind::meet || kind == SweepEventKind::keep;
}

template <typename Kind, typename Counts>
std::uint64_t questions_of(const Counts& counts) {
    std::uint64_t sum = 0;
    for (const Named<Kind>& kind : names<Kind>()) {
        sum += is_question(kind.value) ? counts[static_cast<std::size_t>(kind.value)] : 0U;
    }
    return sum;
}

VisibilityOutcome
outcome_of(scene::Visibility visibility, const Recording& recording, const Recording& reference) {
    VisibilityOutcome outcome{.visibility = visibility, .refusal = {}};
    const Counters& counters = recording.counters;
    outcome.decisions = counters.decisions;
    outcome.sweeps = counters.sweeps;
    const std::uint64_t swept =
        std::accumulate(counters.sweeps.begin(), counters.sweeps.end(), std::uint64_t{0});
    outcome.decision_count =
        std::accumulate(counters.decisions.begin(), counters.decisions.end(), swept);
    outcome.questions =
        questions_of<visibility::OrderEventKind>(counters.decisions) +
        questions_of<visibility::SweepEventKind>(counters.sweeps) +
        (visibility == scene::Visibility::z_buffer ? counters.fragments_tested : 0U);
    outcome.cuts = counters.decisions[static_cast<std::size_t>(visibility::OrderEventKind::split)];
    outcome.parts = recording.order.parts.size();
    outcome.fragments = counters.fragments;
    outcome.written = counters.fates[static_cast<std::size_t>(fragment::FragmentFate::written)];
    outcome.from_z_buffer = difference_of_owners(recording, reference);
    if (const auto& first = outcome.from_z_buffer.first) {
        outcome.shown = recording.final_pixels[*first].triangle;
        outcome.nearest = reference.final_pixels[*first].triangle;
    }
    return outcome;
}

} // namespace

OwnerDifference difference_of_owners(const Recording& a, const Recording& b) {
    OwnerDifference difference;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const PixelPos p{x, y};
            if (a.final_pixels[p].triangle != b.final_pixels[p].triangle) {
                difference.first = difference.first.value_or(p);
                ++difference.pixels;
            }
        }
    }
    return difference;
}

std::vector<VisibilityOutcome> compare_visibility(const scene::Scene& scene) {
    std::vector<VisibilityOutcome> outcomes;
    const auto reference = record_with(scene, scene::Visibility::z_buffer);
    for (const Named<scene::Visibility>& kind : names<scene::Visibility>()) {
        const auto recording = record_with(scene, kind.value);
        if (!reference || !recording) {
            const auto& problems = reference ? recording.diagnostics() : reference.diagnostics();
            outcomes.push_back({.visibility = kind.value, .refusal = problems.front().message});
        } else {
            outcomes.push_back(outcome_of(kind.value, **recording, **reference));
        }
    }
    return outcomes;
}

} // namespace hs::trace
