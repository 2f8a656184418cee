// A line's walk in words and numbers: which pixel comes next, and why.
#pragma once

#include "core/explain/formulas.hpp"
#include "core/raster/line.hpp"

#include <string>
#include <vector>

namespace hs::explain {

std::vector<Formula>
line_setup_formulas(const raster::LineSetup& line, scene::LineAlgorithm algorithm);

/// The decision that led to a pixel.
std::vector<Formula> line_step_formulas(
    const raster::LineSetup& line, const raster::LineStep& step, scene::LineAlgorithm algorithm
);

/// A fragment's place along the line, and its depth.
std::vector<Formula>
line_fragment_formulas(const trace::FragmentDetail& fragment, const trace::PieceDetail& piece);

std::string line_setup_sentence(const std::string& who, const raster::LineSetup& line);
std::string line_step_sentence(
    const std::string& who,
    const raster::LineSetup& line,
    const raster::LineStep& step,
    scene::LineAlgorithm algorithm
);

} // namespace hs::explain
