// Mesh files through OpenMesh's readers, without OpenMesh's half-edge mesh in between: n-gons,
// non-manifold faces, order and indices arrive untouched.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/scene/mesh.hpp"

#include <filesystem>

namespace hs::scene {

/// Reads OBJ, OFF, PLY, STL or OM. Errors: missing, truncated, empty or foreign file, indices out
/// of range, NaN, counts the file cannot hold; located by line where the format has lines. Never
/// allocates more than a small multiple of the file's size. The result satisfies the invariants of
/// Mesh.
Result<Mesh> load_mesh(const std::filesystem::path& path);

/// Whether the name ends like a mesh file this program reads.
bool is_mesh_file(const std::filesystem::path& path);

} // namespace hs::scene
