// OM: OpenMesh's own format. Its reader believes every count, and ends the program over a header it
// does not expect; so only what version 2 writers write by themselves is let through.
#include "core/scene/mesh/prescan.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>

namespace hs::scene::mesh {

namespace {

struct Header {
    std::uint32_t vertices = 0;
    std::uint32_t faces = 0;
    std::uint32_t edges = 0;
};

enum class Entity : unsigned {
    vertex = 0,
    face = 2,
    edge = 4,
    halfedge = 6,
    end = 7
};
enum class Type : unsigned {
    position = 0,
    normal = 1,
    texcoord = 2,
    status = 3,
    color = 4,
    topology = 7
};

/// 16 bits: reserved 1, named 1, entity 3, type 4, signed 1, float 1, dimensions − 1 in 3, log2 of
/// the size in 2.
struct Chunk {
    bool named = false;
    Entity entity = Entity::end;
    Type type = Type::position;
    bool is_float = false;
    unsigned dimensions = 1;
    unsigned log_size = 0;
};

Chunk decode(std::uint16_t bits) {
    return {
        .named = ((bits >> 1U) & 1U) != 0,
        .entity = static_cast<Entity>((bits >> 2U) & 7U),
        .type = static_cast<Type>((bits >> 5U) & 15U),
        .is_float = ((bits >> 10U) & 1U) != 0,
        .dimensions = ((bits >> 11U) & 7U) + 1U,
        .log_size = (bits >> 14U) & 3U,
    };
}

std::uint64_t element_count(Entity entity, const Header& header) {
    switch (entity) {
    case Entity::vertex: return header.vertices;
    case Entity::face: return header.faces;
    case Entity::edge: return header.edges;
    case Entity::halfedge: return 2 * std::uint64_t{header.edges};
    case Entity::end: return 0;
    }
    return 0;
}

/// Bytes per element; nothing for what the reader would not take as we do.
std::optional<std::uint64_t> element_size(const Chunk& chunk) {
    const bool floats = chunk.is_float && chunk.log_size == 0;
    const bool vertex = chunk.entity == Entity::vertex;
    const bool face = chunk.entity == Entity::face;
    const std::uint64_t integer = std::uint64_t{1} << chunk.log_size;
    switch (chunk.type) {
    case Type::position:
        return vertex && floats && chunk.dimensions == 3 ? std::optional{12U} : std::nullopt;
    case Type::normal:
        return (vertex || face) && floats && chunk.dimensions == 3 ? std::optional{12U}
                                                                   : std::nullopt;
    case Type::texcoord:
        return vertex && floats && chunk.dimensions == 2 ? std::optional{8U} : std::nullopt;
    case Type::color:
        return (vertex || face) && !chunk.is_float && chunk.log_size == 0 && chunk.dimensions == 3
                   ? std::optional{3U}
                   : std::nullopt;
    case Type::status: return chunk.dimensions == 1 ? std::optional{4U} : std::nullopt;
    case Type::topology:
        if (chunk.log_size == 3 || chunk.entity == Entity::edge) {
            return std::nullopt;
        }
        // A half-edge has its successor, the vertex it points to and its face.
        return chunk.entity == Entity::halfedge ? 3 * integer : integer;
    }
    return std::nullopt;
}

std::optional<Flaw> scan_chunks(std::string_view rest, const Header& header) {
    while (rest.size() >= 2) {
        std::uint16_t bits = 0;
        std::memcpy(&bits, rest.data(), sizeof bits); // little-endian, as this machine
        rest.remove_prefix(sizeof bits);
        const Chunk chunk = decode(bits);
        if (chunk.entity == Entity::end) {
            return std::nullopt;
        }
        const std::optional<std::uint64_t> size = element_size(chunk);
        if (chunk.named || !size) {
            return Flaw{0, "the file has properties of a kind that is not read"};
        }
        const std::uint64_t bytes = *size * element_count(chunk.entity, header);
        if (bytes > rest.size()) {
            return Flaw{0, "the file ends in the middle of its data"};
        }
        rest.remove_prefix(bytes);
    }
    return Flaw{0, "the file ends before the mark of its end"};
}

} // namespace

std::optional<Flaw> prescan_om(std::string_view bytes) {
    constexpr std::size_t header_size = 16;
    if (bytes.size() < header_size || !bytes.starts_with("OM") ||
        std::string_view{"TQP"}.find(bytes[2]) == std::string_view::npos) {
        return Flaw{0, "the file does not begin like an OM file"};
    }
    const int version = static_cast<unsigned char>(bytes[3]) >> 5;
    if (version != 2) {
        return Flaw{
            0, fmt::format("only OM files of version 2 are read, not of version {}", version)};
    }
    Header header;
    std::memcpy(&header, bytes.data() + 4, sizeof header);
    return scan_chunks(bytes.substr(header_size), header);
}

} // namespace hs::scene::mesh
