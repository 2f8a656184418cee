// Materials and lights.
#include "core/scene/file/scene_reader.hpp"
#include "core/scene/image_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hs::scene::file {

namespace {

std::shared_ptr<const Texture> load(SceneReader& reader, const std::filesystem::path& path) {
    const auto [entry, is_new] = reader.textures.try_emplace(path.string());
    if (is_new) {
        Result<Texture> texture = load_texture(path);
        if (texture) {
            entry->second = std::make_shared<const Texture>(std::move(*texture));
        } else {
            reader.complaints.add(texture.diagnostics());
        }
    }
    return entry->second;
}

void read_texture(SceneReader& reader, const toml::table& toml, Material& material) {
    TableReader table{reader.complaints, toml, "texture"};
    std::string image;
    if (table.read("image", image)) {
        if (const auto path = find_file(reader, *toml.get("image"), image)) {
            material.texture = load(reader, *path);
        }
    } else if (!table.has("image")) {
        table.complain("a texture needs an image: texture = { image = \"name.png\" }");
    }
    table.finish();
}

/// RGB or RGBA.
void read_diffuse(TableReader& table, glm::vec4& diffuse) {
    const toml::node* node = table.find("diffuse");
    if (node == nullptr) {
        return;
    }
    if (const auto numbers = read_floats(*node, 3, 4)) {
        const auto& n = *numbers;
        diffuse = {n[0], n[1], n[2], n.size() == 4 ? n[3] : 1.0F};
    } else {
        table.must_be("diffuse", "a list of 3 or 4 finite numbers");
    }
}

} // namespace

void read_material(SceneReader& reader, const toml::table& toml, std::size_t number) {
    TableReader table{reader.complaints, toml, fmt::format("material {}", number)};
    Material material;
    if (!table.read("name", material.name) && !table.has("name")) {
        table.complain("a material needs a name that objects can refer to");
    }
    if (std::ranges::find(reader.scene.materials, material.name, &Material::name) !=
        reader.scene.materials.end()) {
        table.complain(fmt::format("there are two materials named \"{}\"", material.name));
    }
    read_diffuse(table, material.diffuse);
    table.read("specular", material.specular);
    if (table.read("shininess", material.shininess) && material.shininess < 0.0F) {
        table.must_be("shininess", "at least 0");
    }
    if (const toml::table* texture = table.read_table("texture")) {
        read_texture(reader, *texture, material);
    }
    table.finish();
    reader.scene.materials.push_back(std::move(material));
}

void read_light(SceneReader& reader, const toml::table& toml, std::size_t number) {
    TableReader table{reader.complaints, toml, fmt::format("light {}", number)};
    Light light;
    if (table.has("kind") && !table.read_choice("kind", light.kind)) {
        return; // which keys belong here is unknown
    }
    table.find("kind");
    table.read("color", light.color);
    if (light.kind == LightKind::directional && table.read("to_light", light.to_light) &&
        light.to_light == glm::vec3{0.0F}) {
        table.must_be("to_light", "a direction other than [0, 0, 0]");
    }
    if (light.kind == LightKind::point) {
        table.read("position", light.position);
    }
    table.finish();
    reader.scene.lights.push_back(light);
}

} // namespace hs::scene::file
