#include "core/scene/file/scene_reader.hpp"
#include "core/scene/mesh_file.hpp"
#include "core/scene/shapes.hpp"
#include "core/scene/triangulate.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hs::scene::file {

namespace {

// ---- transform
// ---------------------------------------------------------------------------------------------------

bool read_rotation(TableReader& step, TransformStep& result) {
    const toml::table* toml = step.read_table("rotate");
    if (toml == nullptr) {
        return false;
    }
    TableReader rotate{step.complaints(), *toml, "rotate"};
    const bool axis = rotate.read("axis", result.vector);
    const bool degrees = rotate.read("degrees", result.degrees);
    rotate.finish();
    if (!rotate.has("axis") || !rotate.has("degrees")) {
        rotate.complain("rotate needs an axis and degrees");
    } else if (axis && result.vector == glm::vec3{0.0F}) {
        rotate.must_be("axis", "a direction other than [0, 0, 0]");
    }
    result.kind = TransformStep::Kind::rotate;
    return axis && degrees;
}

/// Four rows, as one writes it on a blackboard.
bool read_matrix(TableReader& step, TransformStep& result) {
    const toml::array* rows = step.read_array("matrix", "4 rows of 4 finite numbers");
    if (rows == nullptr) {
        return false;
    }
    result.kind = TransformStep::Kind::matrix;
    for (int r = 0; r < 4; ++r) {
        const toml::node* row = rows->get(static_cast<std::size_t>(r));
        const auto numbers =
            row == nullptr || rows->size() != 4 ? std::nullopt : read_floats(*row, 4, 4);
        if (!numbers) {
            step.must_be("matrix", "4 rows of 4 finite numbers");
            return false;
        }
        for (int c = 0; c < 4; ++c) {
            result.matrix[c][r] = (*numbers)[static_cast<std::size_t>(c)];
        }
    }
    return true;
}

void read_step(Complaints& complaints, const toml::node& node, Object& object) {
    constexpr std::string_view expected = "a transform step must be one of { translate = … }, { "
                                          "rotate = … }, { scale = … }, { matrix = … }";
    const toml::table* toml = node.as_table();
    if (toml == nullptr || toml->size() != 1) {
        complaints.add(node, std::string{expected});
        return;
    }
    TableReader step{complaints, *toml, "transform"};
    TransformStep result;
    bool good = false;
    if (step.read("translate", result.vector)) {
        result.kind = TransformStep::Kind::translate;
        good = true;
    } else if (step.read("scale", result.vector)) {
        result.kind = TransformStep::Kind::scale;
        good = true;
    } else {
        good = read_rotation(step, result) || read_matrix(step, result);
    }
    step.finish();
    if (good) {
        object.transform.push_back(result);
    }
}

void read_transform(TableReader& table, Object& object) {
    if (const toml::array* steps = table.read_array("transform", "a list of steps")) {
        for (const toml::node& step : *steps) {
            read_step(table.complaints(), step, object);
        }
    }
}

// ---- mesh
// --------------------------------------------------------------------------------------------------------

std::shared_ptr<const Mesh> finished(Result<Mesh> mesh, bool fit) {
    if (fit) {
        fit_to_unit_sphere(*mesh);
    }
    return std::make_shared<const Mesh>(std::move(*mesh));
}

std::shared_ptr<const Mesh> read_mesh_file(SceneReader& reader, TableReader& table, bool fit) {
    std::string name;
    if (!table.read("mesh", name)) {
        return nullptr;
    }
    const toml::node& node = *table.find("mesh");
    const std::optional<std::filesystem::path> path = find_file(reader, node, name);
    if (!path) {
        return nullptr;
    }
    if (!is_mesh_file(*path)) {
        reader.complaints.add(node, "mesh files end in .obj, .off, .ply, .stl or .om");
        return nullptr;
    }
    const auto [entry, is_new] = reader.meshes.try_emplace({path->string(), fit});
    if (is_new) {
        Result<Mesh> mesh = load_mesh(*path);
        if (mesh) {
            entry->second = finished(std::move(mesh), fit);
        } else {
            reader.complaints.add(mesh.diagnostics());
        }
    }
    return entry->second;
}

std::shared_ptr<const Mesh> read_shape(TableReader& object, bool fit) {
    const toml::table* toml = object.read_table("shape");
    if (toml == nullptr) {
        return nullptr;
    }
    constexpr int most_triangles = 20'000'000;
    TableReader table{object.complaints(), *toml, "shape"};
    std::string kind;
    ShapeOptions options;
    const bool has_kind = table.read("kind", kind);
    table.read("triangles", options.triangles, 1, most_triangles);
    table.finish();
    if (!has_kind) {
        if (!table.has("kind")) {
            table.complain("a shape needs a kind: shape = { kind = \"cube\" }");
        }
        return nullptr;
    }
    Result<Mesh> mesh = make_shape(kind, options);
    if (!mesh) {
        object.complaints().add(*toml->get("kind"), mesh.diagnostics().front().message);
        return nullptr;
    }
    return finished(std::move(mesh), fit);
}

std::shared_ptr<const Mesh> read_geometry(SceneReader& reader, TableReader& table) {
    bool fit = false;
    table.read("fit", fit);
    const int sources = static_cast<int>(table.has("vertices")) +
                        static_cast<int>(table.has("mesh")) + static_cast<int>(table.has("shape"));
    if (sources != 1) {
        table.complain(fmt::format(
            "{} must have exactly one of vertices, mesh and shape, not {}", table.name(), sources
        ));
        for (const std::string_view key :
             {"vertices",
              "polygons",
              "lines",
              "points",
              "colors",
              "normals",
              "uvs",
              "mesh",
              "shape"}) {
            table.find(key);
        }
        return nullptr;
    }
    if (table.has("vertices")) {
        return read_inline_mesh(table, fit);
    }
    return table.has("mesh") ? read_mesh_file(reader, table, fit) : read_shape(table, fit);
}

// ---- the rest
// ----------------------------------------------------------------------------------------------------

void read_material_name(SceneReader& reader, TableReader& table, Object& object) {
    std::string name;
    if (!table.read("material", name)) {
        return;
    }
    const std::vector<Material>& materials = reader.scene.materials;
    const auto found = std::ranges::find(materials, name, &Material::name);
    if (found != materials.end()) {
        object.material = static_cast<std::size_t>(found - materials.begin());
        return;
    }
    std::vector<std::string_view> known;
    known.reserve(materials.size());
    for (const Material& material : materials) {
        known.push_back(material.name);
    }
    reader.complaints.add(
        *table.find("material"),
        fmt::format("there is no material \"{}\"{}", name, did_you_mean(name, known))
    );
}

void read_name(SceneReader& reader, TableReader& table, Object& object, std::size_t number) {
    if (!table.read("name", object.name)) {
        object.name = fmt::format("object {}", number);
        return;
    }
    const std::vector<Object>& others = reader.scene.objects;
    if (std::ranges::find(others, object.name, &Object::name) != others.end()) {
        reader.complaints.add(
            *table.find("name"), fmt::format("there are two objects named \"{}\"", object.name)
        );
    }
}

} // namespace

std::optional<std::filesystem::path>
find_file(SceneReader& reader, const toml::node& node, const std::string& name) {
    const std::filesystem::path path = (reader.folder / name).lexically_normal();
    std::error_code ignored;
    if (name.empty() || !std::filesystem::is_regular_file(path, ignored)) {
        reader.complaints.add(node, fmt::format("there is no file \"{}\"", path.string()));
        return std::nullopt;
    }
    std::vector<std::string>& files = reader.scene.files;
    if (std::ranges::find(files, path.string()) == files.end()) {
        files.push_back(path.string());
    }
    return path;
}

void read_placement(SceneReader& reader, const toml::table& toml, Object& object) {
    TableReader table{reader.complaints, toml, fmt::format("object \"{}\"", object.name)};
    object.transform.clear();
    object.material.reset();
    read_transform(table, object);
    read_material_name(reader, table, object);
    table.finish();
}

void read_object(SceneReader& reader, const toml::table& toml, std::size_t number) {
    TableReader table{reader.complaints, toml, fmt::format("object {}", number)};
    Object object;
    read_name(reader, table, object, number);
    read_transform(table, object);
    read_material_name(reader, table, object);
    if (const toml::table* settings = table.read_table("settings")) {
        read_overrides(reader, *settings, object);
    }
    object.mesh = read_geometry(reader, table);
    table.finish();
    reader.scene.objects.push_back(std::move(object));
}

} // namespace hs::scene::file
