// The values of a decision of scanlines or rays: as the algorithm tells them.
#include "core/explain/value_list.hpp"
#include "core/trace/sweep_detail.hpp"

#include <fmt/format.h>

namespace hs::explain {

void add_sweep_values(ValueList& list, const StepContext& context) {
    const trace::SweepDetail detail = trace::sweep_detail(context.recording, context.step);
    const visibility::SweepEvent& event = detail.last();
    const Origin told{{}, {}, fmt::format("told by {}", name_of(event.kind))};
    list.add("x", operand("x", event.x, told));
    list.add("value", operand("value", event.value, told));
    list.add("other value", operand("other value", event.other_value, told));
    list.add("verdict", operand("verdict", event.verdict, told));
}

} // namespace hs::explain
