// Meshes written into the scene file itself.
#include "core/scene/file/scene_reader.hpp"
#include "core/scene/triangulate.hpp"

#include <fmt/format.h>

namespace hs::scene::file {

namespace {

/// Calls `add` with the 3 or 4 (or whatever is allowed) numbers of every entry of a list.
template <typename Add>
void read_list(
    TableReader& object, std::string_view key, std::size_t lowest, std::size_t highest, Add add
) {
    const toml::array* list = object.read_array(key, "a list of lists of numbers");
    if (list == nullptr) {
        return;
    }
    const std::string expected =
        lowest == highest ? std::to_string(lowest) : fmt::format("{} or {}", lowest, highest);
    for (const toml::node& entry : *list) {
        const auto numbers = read_floats(entry, lowest, highest);
        if (!numbers) {
            object.complaints().add(
                entry,
                fmt::format("every entry of {} must be a list of {} finite numbers", key, expected)
            );
        }
        add(numbers.value_or(std::vector<float>(lowest, 0.0F)));
    }
}

void read_vertices(TableReader& object, Mesh& mesh) {
    read_list(object, "vertices", 3, 4, [&](const std::vector<float>& n) {
        mesh.positions.emplace_back(n[0], n[1], n[2], n.size() == 4 ? n[3] : 1.0F);
    });
    read_list(object, "colors", 3, 4, [&](const std::vector<float>& n) {
        mesh.colors.emplace_back(n[0], n[1], n[2], n.size() == 4 ? n[3] : 1.0F);
    });
    read_list(object, "normals", 3, 3, [&](const std::vector<float>& n) {
        mesh.normals.emplace_back(n[0], n[1], n[2]);
    });
    read_list(object, "uvs", 2, 2, [&](const std::vector<float>& n) {
        mesh.uvs.emplace_back(n[0], n[1]);
    });
}

/// One per vertex or none at all.
void check_count(
    TableReader& object, std::string_view key, std::size_t count, std::size_t vertices
) {
    const toml::node* node = object.find(key);
    if (node != nullptr && node->is_array() && count != vertices) {
        object.complaints().add(
            *node,
            fmt::format("there are {} {} for {} vertices: give one each", count, key, vertices)
        );
    }
}

/// The number of a vertex; `what` it is used for, as the complaint says.
std::optional<std::uint32_t>
read_index(TableReader& object, const toml::node& node, const Mesh& mesh, std::string_view what) {
    const auto count = static_cast<std::int64_t>(mesh.positions.size());
    const auto* index = node.as_integer();
    if (index == nullptr) {
        object.complaints().add(node, fmt::format("{} must be the number of a vertex", what));
    } else if (index->get() < 0 || index->get() >= count) {
        object.complaints().add(
            node,
            fmt::format("there is no vertex {}: there are {}, counted from 0", index->get(), count)
        );
    } else {
        return static_cast<std::uint32_t>(index->get());
    }
    return std::nullopt;
}

void read_corner(TableReader& object, const toml::node& node, Mesh& mesh) {
    if (const auto index = read_index(object, node, mesh, "a corner of a polygon")) {
        mesh.polygon_vertices.push_back(*index);
    }
}

void read_lines(TableReader& object, Mesh& mesh) {
    const toml::array* lines = object.read_array("lines", "a list of pairs of vertex numbers");
    if (lines == nullptr) {
        return;
    }
    for (const toml::node& line : *lines) {
        const toml::array* ends = line.as_array();
        if (ends == nullptr || ends->size() != 2) {
            object.complaints().add(line, "a line must be a list of 2 vertex numbers");
            continue;
        }
        const auto from = read_index(object, *ends->get(0), mesh, "an end of a line");
        const auto to = read_index(object, *ends->get(1), mesh, "an end of a line");
        if (from && to) {
            mesh.lines.push_back({*from, *to});
        }
    }
}

void read_points(TableReader& object, Mesh& mesh) {
    const toml::array* points = object.read_array("points", "a list of vertex numbers");
    if (points == nullptr) {
        return;
    }
    for (const toml::node& point : *points) {
        if (const auto index = read_index(object, point, mesh, "a point")) {
            mesh.points.push_back(*index);
        }
    }
}

void read_polygons(TableReader& object, Mesh& mesh) {
    mesh.polygon_start.push_back(0);
    const toml::array* polygons =
        object.read_array("polygons", "a list of lists of vertex numbers");
    if (polygons == nullptr) {
        return;
    }
    for (const toml::node& polygon : *polygons) {
        const toml::array* corners = polygon.as_array();
        if (corners == nullptr || corners->size() < 3 || corners->size() > max_polygon_corners) {
            object.complaints().add(
                polygon,
                fmt::format(
                    "a polygon must be a list of 3 to {} vertex numbers", max_polygon_corners
                )
            );
            continue;
        }
        for (const toml::node& corner : *corners) {
            read_corner(object, corner, mesh);
        }
        mesh.polygon_start.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
    }
}

} // namespace

std::shared_ptr<const Mesh> read_inline_mesh(TableReader& object, bool fit) {
    const bool had_complaints = !object.complaints().empty();
    Mesh mesh;
    read_vertices(object, mesh);
    check_count(object, "colors", mesh.colors.size(), mesh.positions.size());
    check_count(object, "normals", mesh.normals.size(), mesh.positions.size());
    check_count(object, "uvs", mesh.uvs.size(), mesh.positions.size());
    read_polygons(object, mesh);
    read_lines(object, mesh);
    read_points(object, mesh);
    if (!object.has("polygons") && !object.has("lines") && !object.has("points")) {
        object.complain(object.name() + " has vertices but no polygons, lines or points");
    }
    if (had_complaints || !object.complaints().empty()) {
        return nullptr; // the scene is lost: indices may be wrong
    }
    if (fit) {
        fit_to_unit_sphere(mesh);
    }
    finish_mesh(mesh);
    return std::make_shared<const Mesh>(std::move(mesh));
}

} // namespace hs::scene::file
