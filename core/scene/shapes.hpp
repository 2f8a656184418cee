// Generated meshes: exact counts, closed forms, no files.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/scene/mesh.hpp"

#include <string_view>

namespace hs::scene {

struct ShapeOptions {
    int triangles = 0; ///< wanted number, 0: the shape's default; the nearest reachable number is
                       ///< made, at most 20 million
};

/// plane | cube | sphere | torus | torus-knot | teapot, within the unit sphere or [-1, 1]; with
/// normals and texture coordinates. Errors: unknown kind, absurd count.
Result<Mesh> make_shape(std::string_view kind, const ShapeOptions& options);

} // namespace hs::scene
