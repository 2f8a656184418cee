// OM: OpenMesh's own format. Its counts are believed without a look at the file's size.
#include "core/scene/mesh/prescan.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>

namespace hs::scene::mesh {

std::optional<Flaw> prescan_om(std::string_view bytes) {
    struct Counts {
        std::uint32_t vertices, faces, edges;
    } counts{};
    constexpr std::size_t header_size = 16;
    if (bytes.size() < header_size || !bytes.starts_with("OM")) {
        return Flaw{0, "the file does not begin like an OM file"};
    }
    std::memcpy(&counts, bytes.data() + 4, sizeof counts); // little-endian, as this machine
    constexpr std::size_t position_size = 12;
    // Faces and edges take at least one byte each, whatever the version.
    if (position_size * counts.vertices > bytes.size() || counts.faces > bytes.size() ||
        counts.edges > bytes.size()) {
        return Flaw{
            0,
            fmt::format(
                "the file announces {} vertices, {} faces and {} edges, more than it can hold",
                counts.vertices,
                counts.faces,
                counts.edges
            )};
    }
    return std::nullopt;
}

} // namespace hs::scene::mesh
