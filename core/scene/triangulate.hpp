// Polygons to triangles, and the normals a mesh did not bring.
#pragma once

#include "core/scene/mesh.hpp"

namespace hs::scene {

/// Fills `triangles` and `triangle_polygon` from the polygons: each is fanned from its lowest-numbered corner that sees all
/// others, else from a kernel point (a new vertex with interpolated attributes), else cut by ear clipping. Computes
/// area-weighted vertex normals where the mesh has none. Precondition: indices in range, numbers finite.
void finish_mesh(Mesh& mesh);

/// Moves the center of the bounding box to the origin and the farthest vertex to distance 1. A single point stays put.
void fit_to_unit_sphere(Mesh& mesh);

} // namespace hs::scene
