// Polygons to triangles, and the normals a mesh did not bring.
#pragma once

#include "core/scene/mesh.hpp"

#include <cstddef>

namespace hs::scene {

/// Loaders refuse polygons with more corners: cutting ears costs the square of their number.
inline constexpr std::size_t max_polygon_corners = 4096;

/// Fills `triangles` and `triangle_polygon` from the polygons: each is fanned from its
/// lowest-numbered corner that sees all others, else from a kernel point (a new vertex with
/// interpolated attributes), else cut by ear clipping. Computes area-weighted vertex normals where
/// the mesh has none, and brings those it has to unit length. Precondition: indices in range,
/// numbers finite, at least three corners per polygon.
///
/// A corner "sees" another when every triangle of its fan has positive area. Polygons are judged in
/// the coordinate plane that their normal (Newell's) faces most. Polygons without area, or with a
/// corner at w <= 0, are fanned from corner 0; what is left of a polygon that crosses itself when
/// no ear can be cut is fanned, too: n corners always give n - 2 triangles, n with a kernel point.
void finish_mesh(Mesh& mesh);

/// Moves the center of the bounding box to the origin and the farthest vertex to distance 1. A
/// single point stays put.
void fit_to_unit_sphere(Mesh& mesh);

} // namespace hs::scene
