// Parametric surfaces as grids of quads, each cut in two.
#pragma once

#include "core/scene/mesh.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>

namespace hs::scene::shapes {

struct SurfacePoint {
    glm::vec3 position{0.0F};
    glm::vec3 normal{0.0F}; ///< outward, unit length
};

struct GridSize {
    int columns = 1; ///< quads along u
    int rows = 1;    ///< quads along v
};

/// One sheet of (columns + 1) x (rows + 1) vertices is added to the mesh, as triangles or, when
/// `quads`, as polygons of four corners. `point(column, row)` is called once per vertex; the
/// texture coordinate is (column / columns, 1 - row / rows). With column to the right and row up
/// the sheet is counter-clockwise. Triangles that a pole shrinks to a line are left out: those with
/// two equal positions.
void add_sheet(
    Mesh& mesh,
    GridSize size,
    bool quads,
    const std::function<SurfacePoint(int column, int row)>& point
);

/// sin and cos of the angle step / steps of a full turn. Step `steps` is exactly step 0, so that
/// seams close.
struct Turn {
    float sine = 0.0F;
    float cosine = 1.0F;
};
Turn turn(int step, int steps);

} // namespace hs::scene::shapes
