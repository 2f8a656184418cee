// The inspector's tables for a pixel's samples and for the block of four that derivatives need.
#pragma once

#include "app/viewer/panels.hpp"
#include "core/trace/quad_detail.hpp"

namespace hs::viewer {

/// Sample by sample: its edge values.
void draw_sample_edges(Context& context, const trace::StepDetail& detail);
/// Sample by sample: depth, stored depth and what became of the fragment there.
void draw_sample_fates(Context& context, const trace::StepDetail& detail);

/// The samples of a pixel and the color they resolve to.
void draw_resolve(Context& context, const trace::ResolveDetail& resolve);

/// What is interpolated at the four pixels of a block, and the differences.
void draw_quad(Context& context, const trace::QuadDetail& quad);

/// A square of a color, as high as a line of text.
void swatch(const Theme& theme, const glm::vec4& color);

} // namespace hs::viewer
