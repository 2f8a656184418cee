// The values of an ordering algorithm's decisions. Depths are taken over a polygon's corners; what
// an algorithm counted or tried on its way stands as it was logged.
#include "core/explain/value_list.hpp"
#include "core/trace/order_detail.hpp"

#include <fmt/format.h>

namespace hs::explain {
namespace {

using visibility::NewellTest;
using visibility::OrderEvent;
using visibility::OrderEventKind;

/// A polygon's corners' depths, in the window.
std::vector<Wide> depths(const visibility::WindowPolygon& polygon) {
    std::vector<Wide> list;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        list.push_back(operand(
            fmt::format("z{}", i),
            polygon.corners[i].position.z,
            {{}, {}, fmt::format("corner {} of triangle {} in the window", i, polygon.triangle)}
        ));
    }
    return list;
}

Wide extreme(const std::vector<Wide>& depths, const Operation& operation) {
    Wide value = depths.front();
    for (std::size_t i = 1; i < depths.size(); ++i) {
        value = call<double>(operation, value, depths[i]);
    }
    return value;
}

Wide key_term(const visibility::WindowPolygon& polygon, scene::PaintersKey key) {
    const std::vector<Wide> list = depths(polygon);
    switch (key) {
    case scene::PaintersKey::farthest: return extreme(list, operations::larger);
    case scene::PaintersKey::nearest: return extreme(list, operations::smaller);
    case scene::PaintersKey::centroid: break;
    }
    Wide sum{0.0};
    for (const Wide& depth : list) {
        sum = sum + depth;
    }
    return sum / Wide{static_cast<double>(list.size())};
}

/// What a decision's `value` and `other_value` are computed from; false: something else.
bool add_depths(ValueList& list, const StepContext& context, const OrderEvent& event) {
    const bool keys = event.kind == OrderEventKind::compare &&
                      context.recording.settings().visibility == scene::Visibility::painters;
    const bool extents = event.kind == OrderEventKind::test &&
                         static_cast<NewellTest>(event.place) == NewellTest::depth_extents;
    if (!keys && !extents && event.kind != OrderEventKind::take_farthest) {
        return false;
    }
    const trace::OrderDetail detail = trace::order_detail(context.recording, context.step.event);
    const auto polygon = [&](std::int32_t index) -> const visibility::WindowPolygon& {
        return detail.window_polygons()[static_cast<std::size_t>(index)];
    };
    if (keys) {
        const scene::PaintersKey key = context.recording.settings().painters_key;
        const Wide own = list.add("value", key_term(polygon(event.polygon), key));
        const Wide other = list.add("other value", key_term(polygon(event.other), key));
        list.add("verdict", call<bool>(operations::greater, own, other));
    } else if (extents) {
        list.add("value", extreme(depths(polygon(event.polygon)), operations::smaller));
        list.add("other value", extreme(depths(polygon(event.other)), operations::larger));
    } else {
        list.add("value", extreme(depths(polygon(event.polygon)), operations::larger));
    }
    return true;
}

} // namespace

void add_order_values(ValueList& list, const StepContext& context) {
    const OrderEvent& event = context.recording.decisions[context.step.event];
    if (add_depths(list, context, event)) {
        return;
    }
    const std::string given = fmt::format("logged by {}", name_of(event.kind));
    list.add("value", operand("value", event.value, {{}, {}, given}));
    list.add("other value", operand("other value", event.other_value, {{}, {}, given}));
    list.add("verdict", operand("verdict", event.verdict, {{}, {}, given}));
}

} // namespace hs::explain
