// Lighting with every term in numbers: what each light adds at a vertex or at a fragment, and how a
// fragment comes by a color that was lit at the vertices.
#pragma once

#include "core/explain/formulas.hpp"

namespace hs::explain {

/// The sum of all terms, then one formula per light.
std::vector<Formula>
lighting_formulas(const shading::LightingTerms& terms, const trace::LitPoint& point);

/// The mix of three lit colors at a fragment. Empty where colors were not lit per vertex, or the
/// triangle was clipped and the three are not its corners'.
std::vector<Formula> mixed_color_formulas(
    const trace::TriangleDetail& triangle,
    const trace::FragmentDetail& fragment,
    const scene::Settings& settings
);

} // namespace hs::explain
