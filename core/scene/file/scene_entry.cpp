// A scene's parts are written as the tables they were read from, changed there, and read again: so
// every check of the file holds.
#include "core/scene/scene_entry.hpp"

#include "core/base/spelling.hpp"
#include "core/scene/file/scene_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <sstream>

namespace hs::scene {
namespace {

using file::Complaints;
using file::SceneReader;

/// The shortest number that is read as this one: 0.4, not 0.40000000596.
double real(float value) {
    const std::string text = fmt::format("{}", value);
    double result = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), result);
    return result;
}

toml::array floats(std::span<const float> values) {
    toml::array list;
    for (const float value : values) {
        list.push_back(real(value));
    }
    return list;
}

toml::array floats(const glm::vec3& v) {
    return floats(std::array{v.x, v.y, v.z});
}

// ---- tables of what is in memory

toml::table limits_table(const Projection& projection) {
    switch (projection.kind) {
    case ProjectionKind::perspective: return toml::table{{"fov_y", real(projection.fov_y)}};
    case ProjectionKind::orthographic: return toml::table{{"height", real(projection.height)}};
    case ProjectionKind::frustum:
        return toml::table{
            {"left", real(projection.left)},
            {"right", real(projection.right)},
            {"bottom", real(projection.bottom)},
            {"top", real(projection.top)}};
    case ProjectionKind::identity: return {};
    }
    HS_CHECK(false, "every projection kind is handled");
    return {};
}

toml::table projection_table(const Projection& projection) {
    toml::table table = limits_table(projection);
    table.insert("kind", name_of(projection.kind));
    if (projection.kind != ProjectionKind::identity) {
        table.insert("near", real(projection.near));
        table.insert("far", real(projection.far));
    }
    return table;
}

toml::table camera_table(const Camera& camera) {
    return toml::table{
        {"eye", floats(camera.eye)},
        {"target", floats(camera.target)},
        {"up", floats(camera.up)},
        {"forward", name_of(camera.forward)},
        {"projection", projection_table(camera.projection)}};
}

toml::table step_table(const TransformStep& step) {
    switch (step.kind) {
    case TransformStep::Kind::translate: return toml::table{{"translate", floats(step.vector)}};
    case TransformStep::Kind::scale: return toml::table{{"scale", floats(step.vector)}};
    case TransformStep::Kind::rotate:
        return toml::table{
            {"rotate",
             toml::table{{"axis", floats(step.vector)}, {"degrees", real(step.degrees)}}}};
    case TransformStep::Kind::matrix: {
        toml::array rows;
        for (int row = 0; row < 4; ++row) {
            const glm::mat4& m = step.matrix;
            rows.push_back(floats(std::array{m[0][row], m[1][row], m[2][row], m[3][row]}));
        }
        return toml::table{{"matrix", std::move(rows)}};
    }
    }
    HS_CHECK(false, "every kind of step is handled");
    return {};
}

toml::table object_table(const Scene& scene, const Object& object) {
    toml::array steps;
    for (const TransformStep& step : object.transform) {
        steps.push_back(step_table(step));
    }
    toml::table table{{"transform", std::move(steps)}};
    if (object.material) {
        table.insert("material", scene.materials[*object.material].name);
    }
    return table;
}

// ---- paths

/// "object.ball.transform" to its first, its second and its third word.
std::array<std::string_view, 3> first_words(std::string_view path) {
    std::array<std::string_view, 3> words;
    for (std::string_view& word : words) {
        const std::size_t dot = std::min(path.find('.'), path.size());
        word = path.substr(0, dot);
        path.remove_prefix(std::min(dot + 1, path.size()));
    }
    return words;
}

Object* find_object(Scene& scene, std::string_view word) {
    std::size_t number = 0;
    const char* const end = word.data() + word.size();
    const auto [rest, error] = std::from_chars(word.data(), end, number);
    if (error == std::errc{} && rest == end && number < scene.objects.size()) {
        return &scene.objects[number];
    }
    const auto named = std::ranges::find(scene.objects, word, &Object::name);
    return named == scene.objects.end() ? nullptr : &*named;
}

std::string no_object(const Scene& scene, std::string_view word) {
    std::vector<std::string_view> known;
    for (const Object& object : scene.objects) {
        known.emplace_back(object.name);
    }
    return fmt::format("there is no object \"{}\"{}", word, did_you_mean(word, known));
}

/// What the path leads into, as the scene file has it.
toml::table root_of(Scene& scene, std::string_view path) {
    const auto [part, word, key] = first_words(path);
    if (part == "camera") {
        return toml::table{{"camera", camera_table(scene.camera)}};
    }
    toml::table objects;
    if (const Object* object = find_object(scene, word)) {
        objects.insert(word, object_table(scene, *object));
    }
    return toml::table{{"object", std::move(objects)}};
}

/// Another kind of projection has other keys: those of the old one go, but for the one that was
/// assigned.
void drop_foreign_keys(toml::table& projection, std::string_view assigned) {
    const auto kind = parse_name<ProjectionKind>(projection["kind"].value_or(std::string_view{}));
    if (!kind || assigned != "camera.projection.kind") {
        return;
    }
    Projection other;
    other.kind = *kind;
    const toml::table known = projection_table(other);
    for (const std::string_view key :
         {"fov_y", "height", "left", "right", "bottom", "top", "near", "far"}) {
        if (!known.contains(key)) {
            projection.erase(key);
        }
    }
}

std::optional<std::string> first_of(const Complaints& complaints) {
    return complaints.empty() ? std::nullopt : std::optional{complaints.sorted().front().message};
}

std::optional<std::string>
read_camera_again(SceneReader& reader, toml::table& root, std::string_view path) {
    toml::table* const camera = root["camera"].as_table();
    if (camera == nullptr) {
        return "camera is a table: name one of its entries, as in camera.eye";
    }
    if (toml::table* const projection = (*camera)["projection"].as_table()) {
        drop_foreign_keys(*projection, path);
    }
    reader.scene.camera = {};
    file::read_camera(reader, *camera);
    return first_of(reader.complaints);
}

std::optional<std::string>
read_object_again(SceneReader& reader, toml::table& root, std::string_view word) {
    const toml::table* const table = root["object"][word].as_table();
    if (table == nullptr) {
        return fmt::format(
            "object.{} is a table: name one of its entries, as in object.{}.transform", word, word
        );
    }
    file::read_placement(reader, *table, *find_object(reader.scene, word));
    return first_of(reader.complaints);
}

} // namespace

bool is_scene_entry(std::string_view path) {
    const std::string_view part = first_words(path)[0];
    return part == "camera" || part == "object";
}

std::optional<std::string> change_entry(Scene& scene, const Assignment& change) {
    const auto [part, word, key] = first_words(change.path);
    const bool of_object = part == "object";
    if (of_object && find_object(scene, word) == nullptr) {
        return no_object(scene, word);
    }
    if (of_object && !key.empty() && key != "transform" && key != "material") {
        return fmt::format(
            "{} is no entry that can be changed here: an object's transform and material can", key
        );
    }
    toml::table root = root_of(scene, change.path);
    Complaints complaints{""};
    file::apply_assignments(root, std::span{&change, 1}, complaints);
    if (!complaints.empty()) {
        return first_of(complaints);
    }
    SceneReader reader{scene, complaints, {}};
    return of_object ? read_object_again(reader, root, word)
                     : read_camera_again(reader, root, change.path);
}

std::string print_entry(const Scene& scene, std::string_view path) {
    Scene copy = scene; // tables are made from what may be changed
    const toml::table root = root_of(copy, path);
    const toml::node* found = &root;
    while (!path.empty() && found != nullptr) {
        const std::size_t dot = std::min(path.find('.'), path.size());
        const std::string_view word = path.substr(0, dot);
        path.remove_prefix(std::min(dot + 1, path.size()));
        std::size_t index = 0;
        const auto parsed = std::from_chars(word.data(), word.data() + word.size(), index);
        const toml::array* const list = found->as_array();
        if (const toml::table* const table = found->as_table()) {
            found = table->get(word);
        } else {
            found = list != nullptr && parsed.ec == std::errc{} ? list->get(index) : nullptr;
        }
    }
    if (found == nullptr) {
        return "";
    }
    // Within a list a table stands on one line
    toml::array list;
    found->visit([&list](const auto& typed) { list.push_back(typed); });
    std::ostringstream printed;
    printed << list;
    const std::string text = printed.str();
    const std::size_t first = text.find_first_not_of(" \n", 1); // past the list's own bracket
    const std::size_t last = text.find_last_not_of(" \n", text.size() - 2);
    return text.substr(first, last - first + 1);
}

} // namespace hs::scene
