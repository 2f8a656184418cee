// What is drawn in the space view: meshes, the view volume with its depths, the eye, axes and the
// current triangle.
#pragma once

#include "app/viewer/panels.hpp"
#include "app/viewer/space_lines.hpp"

namespace hs::viewer {

/// Precondition: the lines are up to date.
void draw_spaces_content(Context& context, const SpaceLines& lines);

/// Distances from the eye at which sections of the view volume are drawn: multiples of 1, 2 or 5
/// and a power of ten, a handful of them up to `interest`, beyond it at most `most`.
std::vector<float> section_distances(const ViewVolume& volume, float interest, int most);

} // namespace hs::viewer
