// Every value a step computed, by name, with the formula that gave it and where its operands came
// from: "every number explains itself".
//
// Names are stable: command lines, lessons and links in the window write them.
#pragma once

#include "core/explain/term.hpp"
#include "core/trace/detail.hpp"
#include "core/trace/recording.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hs::explain {

struct StepValue {
    std::string name; ///< "clip.x", "E01", "stored depth"
    ExpressionPtr expression;
};

/// In the order they are computed. Empty for `end`, which computes nothing. `detail` is the step's.
std::vector<StepValue> step_values(
    const trace::Recording& recording, const trace::Step& step, const trace::StepDetail& detail
);

/// The value of that name; null without one.
const StepValue* find_value(const std::vector<StepValue>& values, std::string_view name);

/// Where a value's operand came from, to go there.
struct Source {
    trace::StepId step = 0;
    std::string value;
};
/// Empty for what no step produced, and for steps of another frame.
std::optional<Source> source_of(const trace::Recording& recording, const Origin& origin);

/// "stored depth of object 0 / triangle 3 / fragment 4,5 / merge", "camera.projection"; empty for
/// constants.
std::string origin_text(const Origin& origin);

} // namespace hs::explain
