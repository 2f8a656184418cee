#include "core/scene/mesh_file.hpp"

#include "core/base/hash.hpp"
#include "core/scene/mesh/importer.hpp"
#include "core/scene/mesh/prescan.hpp"
#include "core/scene/triangulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <optional>
#include <unordered_map>

namespace hs::scene {

namespace {

using mesh::Corner;
using mesh::Flaw;
using mesh::RawMesh;

constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 30U;

struct Format {
    std::string_view extension;
    std::optional<Flaw> (*prescan)(std::string_view bytes);
};

constexpr Format formats[] = {
    {".obj", mesh::prescan_obj},
    {".off", mesh::prescan_off},
    {".ply", mesh::prescan_ply},
    {".stl", mesh::prescan_stl},
    {".om", mesh::prescan_om},
};

const Format* find_format(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) {
        return static_cast<char>(std::tolower(c));
    });
    const Format* found = std::ranges::find(formats, extension, &Format::extension);
    return found == std::end(formats) ? nullptr : found;
}

Result<std::string> read_bytes(const std::filesystem::path& path) {
    const auto complaint = [&](std::string message) {
        return Diagnostic{path.string(), 0, 0, std::move(message)};
    };
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        return complaint("there is no such file");
    }
    if (std::filesystem::file_size(path, error) > largest_file) {
        return complaint("a mesh file can have at most 1 GB");
    }
    std::ifstream stream{path, std::ios::binary};
    std::string bytes{std::istreambuf_iterator<char>{stream}, {}};
    if (!stream.is_open() || stream.bad()) {
        return complaint("the file cannot be read");
    }
    return bytes;
}

/// Corners of one file vertex with different attributes become vertices of their own: the first
/// keeps the number, the others are appended.
class VertexSplitter {
public:
    VertexSplitter(const RawMesh& raw, Mesh& result)
        : raw_(raw), result_(result), taken_(raw.positions.size(), false) {
        for (const glm::vec3& p : raw.positions) {
            result_.positions.emplace_back(p, 1.0F);
        }
        result_.colors = raw.colors;
        result_.uvs.resize(raw.has_uvs ? raw.positions.size() : 0, glm::vec2{0.0F});
        result_.normals.resize(raw.has_normals ? raw.positions.size() : 0, glm::vec3{0.0F});
    }

    /// The vertex that has the corner's attributes.
    std::uint32_t vertex_of(const Corner& corner) {
        std::uint32_t vertex = corner.vertex;
        if (!taken_[vertex]) {
            taken_[vertex] = true;
            set_attributes(vertex, corner);
            return vertex;
        }
        if (has_attributes(vertex, corner)) {
            return vertex;
        }
        const auto [variant, is_new] = variants_.try_emplace(corner, 0U);
        if (is_new) {
            variant->second = append(corner);
        }
        return variant->second;
    }

private:
    struct Hash {
        std::size_t operator()(const Corner& c) const {
            Digest digest;
            digest.add(c.vertex);
            for (const float x : {c.uv.x, c.uv.y, c.normal.x, c.normal.y, c.normal.z}) {
                digest.add(x);
            }
            return digest.value();
        }
    };

    void set_attributes(std::uint32_t vertex, const Corner& corner) {
        if (raw_.has_uvs) {
            // v is up in mesh files and down in images.
            result_.uvs[vertex] = {corner.uv.x, 1.0F - corner.uv.y};
        }
        if (raw_.has_normals) {
            result_.normals[vertex] = corner.normal;
        }
    }

    [[nodiscard]] bool has_attributes(std::uint32_t vertex, const Corner& corner) const {
        const glm::vec2 uv{corner.uv.x, 1.0F - corner.uv.y};
        return (!raw_.has_uvs || result_.uvs[vertex] == uv) &&
               (!raw_.has_normals || result_.normals[vertex] == corner.normal);
    }

    std::uint32_t append(const Corner& corner) {
        const auto vertex = static_cast<std::uint32_t>(result_.positions.size());
        if (result_.file_vertex.empty()) {
            for (std::uint32_t i = 0; i < vertex; ++i) {
                result_.file_vertex.push_back(i);
            }
        }
        result_.file_vertex.push_back(corner.vertex);
        result_.positions.push_back(result_.positions[corner.vertex]);
        if (!result_.colors.empty()) {
            result_.colors.push_back(result_.colors[corner.vertex]);
        }
        result_.uvs.resize(raw_.has_uvs ? result_.positions.size() : 0);
        result_.normals.resize(raw_.has_normals ? result_.positions.size() : 0);
        set_attributes(vertex, corner);
        return vertex;
    }

    const RawMesh& raw_;
    Mesh& result_;
    std::vector<bool> taken_;
    std::unordered_map<Corner, std::uint32_t, Hash> variants_; ///< only looked up, never iterated
};

/// A cheap second look at everything, whatever the prescan and the reader believed.
std::optional<std::string> find_bad_number(const RawMesh& raw) {
    const auto finite = [](float x) { return std::isfinite(x); };
    for (std::size_t i = 0; i < raw.positions.size(); ++i) {
        const glm::vec3& p = raw.positions[i];
        if (!finite(p.x) || !finite(p.y) || !finite(p.z)) {
            return fmt::format("vertex {} is not finite", i);
        }
    }
    for (const glm::vec4& c : raw.colors) {
        if (!finite(c.x) || !finite(c.y) || !finite(c.z) || !finite(c.w)) {
            return std::string{"a color is not finite"};
        }
    }
    for (const Corner& corner : raw.corners) {
        if (!finite(corner.uv.x) || !finite(corner.uv.y) || !finite(corner.normal.x) ||
            !finite(corner.normal.y) || !finite(corner.normal.z)) {
            return fmt::format(
                "a normal or texture coordinate of vertex {} is not finite", corner.vertex
            );
        }
    }
    for (std::size_t i = 0; i + 1 < raw.face_start.size(); ++i) {
        const std::size_t corners = raw.face_start[i + 1] - raw.face_start[i];
        if (corners < 3 || corners > max_polygon_corners) {
            return fmt::format(
                "face {} has {} corners: 3 to {} are possible", i, corners, max_polygon_corners
            );
        }
    }
    return std::nullopt;
}

Mesh to_mesh(const RawMesh& raw, const std::filesystem::path& path) {
    Mesh result;
    result.name = path.stem().string();
    VertexSplitter splitter{raw, result};
    result.polygon_start = raw.face_start;
    result.polygon_vertices.reserve(raw.corners.size());
    for (const Corner& corner : raw.corners) {
        result.polygon_vertices.push_back(splitter.vertex_of(corner));
    }
    finish_mesh(result);
    return result;
}

} // namespace

bool is_mesh_file(const std::filesystem::path& path) {
    return find_format(path) != nullptr;
}

Result<Mesh> load_mesh(const std::filesystem::path& path) {
    const Format* format = find_format(path);
    if (format == nullptr) {
        return Diagnostic{path.string(), 0, 0, "mesh files end in .obj, .off, .ply, .stl or .om"};
    }
    const Result<std::string> bytes = read_bytes(path);
    if (!bytes) {
        return bytes.diagnostics();
    }
    if (const std::optional<Flaw> flaw = format->prescan(*bytes)) {
        return Diagnostic{path.string(), flaw->line, 0, flaw->message};
    }
    const Result<RawMesh> raw = mesh::import_file(path, *bytes);
    if (!raw) {
        return raw.diagnostics();
    }
    if (const auto message = find_bad_number(*raw)) {
        return Diagnostic{path.string(), 0, 0, *message};
    }
    if (raw->corners.empty()) {
        return Diagnostic{path.string(), 0, 0, "the file has no faces"};
    }
    return to_mesh(*raw, path);
}

} // namespace hs::scene
