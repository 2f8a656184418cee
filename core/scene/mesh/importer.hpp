// OpenMesh's readers, calling back as they read. Knows OpenMesh; nothing else does.
#pragma once

#include "core/base/diagnostic.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace hs::scene::mesh {

/// One corner of a face. Which of the attributes count is said by RawMesh.
struct Corner {
    std::uint32_t vertex = 0;
    glm::vec2 uv{0.0F};
    glm::vec3 normal{0.0F};
    friend bool operator==(const Corner&, const Corner&) = default;
};

/// What stands in the file: nothing shared, split, dropped or reordered.
struct RawMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec4> colors; ///< empty, or one per vertex
    bool has_uvs = false;
    bool has_normals = false;
    std::vector<std::uint32_t> face_start{0}; ///< faces + 1 offsets
    std::vector<Corner> corners;
};

/// Reads a file whose prescan found no flaw. `bytes` is its content.
Result<RawMesh> import_file(const std::filesystem::path& path, const std::string& bytes);

} // namespace hs::scene::mesh
