// The steps of traversals in words and formulas: tiles, edge tables, spans, running edge values.
#pragma once

#include "core/explain/formulas.hpp"

#include <string>
#include <vector>

namespace hs::explain {

/// For edge_table, tile_test, active_edges and span; `who` is "triangle 12".
/// Precondition: the detail is that step's.
std::string traversal_sentence(
    const std::string& who,
    const trace::Step& step,
    const trace::TraversalDetail& detail,
    const raster::TriangleSetup& setup
);

/// For the same kinds.
std::vector<Formula> traversal_formulas(
    const trace::TraversalDetail& detail,
    const trace::Step& step,
    const raster::TriangleSetup& setup
);

/// For plane_test.
std::string plane_sentence(
    const std::string& who,
    const trace::Step& step,
    const raster::HomogeneousSetup& setup,
    const raster::PlaneTest& test
);
std::vector<Formula> plane_formulas(
    const trace::Step& step, const raster::HomogeneousSetup& setup, const raster::PlaneTest& test
);
/// For the setup of homogeneous rasterization.
std::vector<Formula> plane_setup_formulas(const raster::HomogeneousSetup& setup);

/// How a traversal that moves edge values came by those of a visited pixel: from which neighbor, by
/// which additions. Empty where they were evaluated.
std::vector<Formula> running_edge_formulas(
    const trace::StepDetail& detail, const trace::Step& step, scene::TraversalKind traversal
);

} // namespace hs::explain
