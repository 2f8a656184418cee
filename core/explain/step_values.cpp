#include "core/explain/step_values.hpp"

#include "core/explain/value_list.hpp"
#include "core/trace/player.hpp"

#include <algorithm>

namespace hs::explain {
namespace {

using trace::StepKind;

void add_values(ValueList& list, const StepContext& context) {
    switch (context.step.kind) {
    case StepKind::start: return add_start_values(list, context);
    case StepKind::vertex_world:
    case StepKind::vertex_eye:
    case StepKind::vertex_clip:
    case StepKind::vertex_light: return add_vertex_values(list, context);
    case StepKind::order: return add_order_values(list, context);
    case StepKind::sweep: return add_sweep_values(list, context);
    case StepKind::outcodes: return add_outcode_values(list, context);
    case StepKind::clip_plane: return add_clip_values(list, context);
    case StepKind::divide: return add_divide_values(list, context);
    case StepKind::viewport: return add_viewport_values(list, context);
    case StepKind::facing: return add_facing_values(list, context);
    case StepKind::setup: return add_setup_values(list, context);
    case StepKind::edge_table:
    case StepKind::active_edges:
    case StepKind::span: return add_scan_values(list, context);
    case StepKind::tile_test: return add_tile_values(list, context);
    case StepKind::edge_test: return add_edge_test_values(list, context);
    case StepKind::sample_test: return add_sample_test_values(list, context);
    case StepKind::plane_test: return add_plane_test_values(list, context);
    case StepKind::line_step: return add_line_step_values(list, context);
    case StepKind::interpolate: return add_interpolation_values(list, context);
    case StepKind::shade: return add_shading_values(list, context);
    case StepKind::scissor_test:
    case StepKind::closed_test:
    case StepKind::depth_test: return add_test_values(list, context);
    case StepKind::merge: return add_merge_values(list, context);
    case StepKind::resolve: return add_resolve_values(list, context);
    case StepKind::end: return;
    }
    HS_CHECK(false, "every step kind explains its values");
}

} // namespace

std::vector<StepValue> step_values(
    const trace::Recording& recording, const trace::Step& step, const trace::StepDetail& detail
) {
    ValueList list(trace::step_path(step));
    add_values(list, {recording, step, detail});
    return list.take();
}

const StepValue* find_value(const std::vector<StepValue>& values, std::string_view name) {
    const auto found = std::ranges::find(values, name, &StepValue::name);
    return found == values.end() ? nullptr : &*found;
}

std::optional<Source> source_of(const trace::Recording& recording, const Origin& origin) {
    if (origin.step.empty()) {
        return std::nullopt;
    }
    const Result<trace::StepId> step = trace::find_step(recording, origin.step);
    return step ? std::optional{Source{*step, origin.value}} : std::nullopt;
}

std::string origin_text(const Origin& origin) {
    return origin.step.empty() ? origin.given : origin.value + " of " + origin.step;
}

} // namespace hs::explain
