// Formulas behind a step: symbols, the same with this step's numbers, and the value they gave.
#pragma once

#include "core/scene/settings.hpp"
#include "core/trace/detail.hpp"
#include "core/trace/step.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace hs::explain {

struct Formula {
    std::string title;
    std::string symbolic;
    std::string with_numbers; ///< lines separated by '\n'; may be empty
    std::string value;
    /// What it computes, by the names that lessons use: "ndc", "λ0".
    std::vector<std::string_view> quantities{};
};

/// In the order they are computed. `settings` are those of the step's object (object_settings).
/// Empty for steps that compute nothing: start and end.
std::vector<Formula>
formulas(const trace::StepDetail& detail, const trace::Step& step, const scene::Settings& settings);

/// The formulas of one part, whatever step the playhead stands on.
std::vector<Formula> vertex_formulas(const trace::VertexDetail& vertex);
std::vector<Formula>
edge_formulas(const raster::TriangleSetup& setup, const trace::VisitDetail& visit);
std::vector<Formula> fragment_formulas(
    const trace::FragmentDetail& fragment,
    const trace::PieceDetail& piece,
    const scene::Settings& settings
);

} // namespace hs::explain
