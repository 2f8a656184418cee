// Formulas of the stages before traversal, for formulas.cpp.
#pragma once

#include "core/explain/formulas.hpp"

namespace hs::explain {

Formula divide_formula(const math::ClipPosition& clip, const geometry::WindowVertex& v);
Formula inv_w_formula(int vertex, const geometry::WindowVertex& v);
Formula snap_formula(int vertex, const geometry::WindowVertex& v);
std::vector<Formula>
outcode_formulas(const trace::TriangleDetail& triangle, const scene::Settings& settings);
std::vector<Formula> clip_formulas(
    const trace::TriangleDetail& triangle,
    geometry::ClipPlane plane,
    const scene::Settings& settings
);
Formula facing_formula(const trace::PieceDetail& piece);
std::vector<Formula> setup_formulas(const raster::TriangleSetup& setup);

} // namespace hs::explain
