// Formulas as the inspector draws them.
#pragma once

#include "app/viewer/panels.hpp"
#include "core/explain/formulas.hpp"

#include <glm/mat4x4.hpp>

#include <span>
#include <string_view>

namespace hs::viewer {

/// Title, symbols, numbers, value; `lit` marks what this step computed. What the lesson points at
/// is framed.
void draw_formula(const Context& context, const explain::Formula& formula, bool lit);

/// A matrix as four aligned rows.
void draw_matrix(const Theme& theme, std::string_view title, const glm::mat4& matrix);

/// The formulas of the current step, marked; nothing when it computes none.
void draw_step_formulas(const Context& context, std::span<const explain::Formula> formulas);

} // namespace hs::viewer
