// From flat step numbers to addresses, and to the ends of fragments and triangles.
#include "core/trace/outline.hpp"
#include "core/trace/player.hpp"

#include <algorithm>

namespace hs::trace {
namespace {

Step describe_vertex_step(const Recording& recording, StepId step) {
    const auto after = std::upper_bound(
        recording.objects.begin(),
        recording.objects.end(),
        step,
        [](StepId s, const ObjectRange& object) { return s < object.first_vertex_step; }
    );
    const ObjectRange& object = *(after - 1);
    const StepId offset = step - object.first_vertex_step;
    const auto per_vertex = static_cast<StepId>(object.steps_per_vertex);
    Step result;
    result.id = step;
    result.object = static_cast<std::uint32_t>(&object - recording.objects.data());
    result.vertex = static_cast<std::uint32_t>(offset / per_vertex);
    result.kind =
        static_cast<StepKind>(static_cast<StepId>(StepKind::vertex_world) + offset % per_vertex);
    return result;
}

/// One per pixel, row by row.
Step describe_resolve_step(const Recording& recording, StepId step) {
    const auto pixel = static_cast<int>(step - recording.first_resolve_step);
    Step result;
    result.id = step;
    result.kind = StepKind::resolve;
    result.pixel = {pixel % recording.width(), pixel / recording.width()};
    return result;
}

Step describe_order_step(const Recording& recording, StepId step) {
    const std::size_t event = step - recording.first_order_step;
    Step result;
    result.id = step;
    result.kind = StepKind::order;
    result.decision = recording.decisions[event].kind;
    result.event = static_cast<std::uint32_t>(event);
    result.ordinal = static_cast<std::uint32_t>(recording.decisions.counts_before(event
    )[static_cast<std::size_t>(result.decision)]);
    return result;
}

} // namespace

Step describe_step(const Recording& recording, StepId step) {
    HS_CHECK(step <= recording.end_step, "a step of this recording");
    Step result;
    result.id = step;
    if (step == recording.end_step) {
        result.kind = StepKind::end;
        return result;
    }
    if (step == 0) {
        return result;
    }
    if (step < recording.first_order_step) {
        return describe_vertex_step(recording, step);
    }
    if (step < recording.first_triangle_step) {
        return describe_order_step(recording, step);
    }
    if (step >= recording.first_resolve_step) {
        return describe_resolve_step(recording, step);
    }
    const Outline window = outline(recording, index_entry_of_step(recording, step));
    return window.steps[step - window.first_step];
}

StepId last_step_of_fragment(const Recording& recording, std::uint32_t fragment) {
    HS_CHECK(fragment < recording.fragments.size(), "a fragment of this recording");
    const auto after = std::upper_bound(
        recording.index.begin(),
        recording.index.end(),
        fragment,
        [](std::uint32_t f, const IndexEntry& entry) { return f < entry.fragment; }
    );
    const auto entry = static_cast<std::size_t>(after - recording.index.begin()) - 1;
    const Outline window = outline(recording, entry);
    const auto last =
        std::find_if(window.steps.rbegin(), window.steps.rend(), [fragment](const Step& s) {
            return s.in_fragment() && s.fragment == fragment;
        });
    HS_CHECK(last != window.steps.rend(), "a re-run draws the fragments it drew when recorded");
    return last->id;
}

StepId last_step_of_triangle(const Recording& recording, std::uint32_t triangle) {
    HS_CHECK(triangle < recording.triangles.size(), "a triangle of this recording");
    return last_step_of_draw(recording, recording.triangles[triangle].last_draw);
}

StepId last_step_of_draw(const Recording& recording, std::uint32_t draw) {
    HS_CHECK(draw < recording.draw_steps.size(), "a draw of this recording");
    const bool last = draw + 1 == recording.draw_steps.size();
    return (last ? recording.first_resolve_step : recording.draw_steps[draw + 1]) - 1;
}

} // namespace hs::trace
