// The families of generated shapes. Every function takes the wanted number of triangles and makes
// the nearest number it can reach; positions, normals, texture coordinates and polygons are set,
// `finish_mesh` does the rest.
#pragma once

#include "core/scene/mesh.hpp"

namespace hs::scene::shapes {

Mesh plane(int triangles);
Mesh cube(int triangles);
Mesh sphere(int triangles);
Mesh torus(int triangles);
Mesh torus_knot(int triangles);
Mesh teapot(int triangles);

} // namespace hs::scene::shapes
