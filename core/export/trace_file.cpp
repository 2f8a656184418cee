// The layout of a trace:
//   manifest.json     what it is, where it comes from, what its numbers mean
//   <column>.npy      the columns of every table
//   <column>.names.npy  the names of a column of enumerators
//   files/…           scene, meshes and images; those of the scene's folder keep their places in it
#include "core/export/trace_file.hpp"

#include "core/base/hash.hpp"
#include "core/base/version.hpp"
#include "core/export/column.hpp"
#include "core/export/npz.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

namespace hs::exporting {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using trace::Recording;

constexpr int format_version = 1;

/// Builds with the same tag record the same bits. It names the arithmetic, not the machine.
constexpr std::string_view determinism_tag = "24.8 fixed, float32, no contraction";

std::string hex(std::uint64_t value) {
    return fmt::format("{:016x}", value);
}

std::string digest_of(std::string_view text) {
    Digest digest;
    digest.add_bytes(std::as_bytes(std::span{text.data(), text.size()}));
    return hex(digest.value());
}

ordered_json settings_json(const scene::Settings& settings) {
    ordered_json result;
    for (const scene::SettingInfo& info : scene::setting_infos()) {
        result[std::string{info.key}] = scene::print_setting(settings, info.key);
    }
    return result;
}

ordered_json counters_json(const trace::Counters& counters) {
    ordered_json result;
    for (const Column& column : counter_table(counters).columns) {
        std::uint64_t value = 0;
        column.read(0, &value);
        result[column.name.substr(column.name.find('.') + 1)] = value;
    }
    return result;
}

/// Rows from the top, as written on a board: matrix · column vector.
ordered_json matrix_json(const glm::mat4& matrix) {
    ordered_json rows = ordered_json::array();
    for (int r = 0; r < 4; ++r) {
        rows.push_back({matrix[0][r], matrix[1][r], matrix[2][r], matrix[3][r]});
    }
    return rows;
}

ordered_json objects_json(const Recording& recording) {
    ordered_json objects = ordered_json::array();
    for (std::size_t i = 0; i < recording.objects.size(); ++i) {
        const trace::ObjectRange& range = recording.objects[i];
        const pipeline::Transforms& transforms = recording.frame->calls()[i].vertex.transforms;
        objects.push_back(
            {{"name", recording.scene().objects[i].name},
             {"first_vertex", range.first_vertex},
             {"vertices", range.vertex_count},
             {"first_triangle", range.first_triangle},
             {"triangles", range.triangle_count},
             {"object_to_world", matrix_json(transforms.model.matrix)},
             {"world_to_eye", matrix_json(transforms.view.matrix)},
             {"eye_to_clip", matrix_json(transforms.projection.matrix)}}
        );
    }
    return objects;
}

ordered_json enumerations_json(std::span<const Table> tables) {
    ordered_json enumerations = ordered_json::object();
    for (const Table& table : tables) {
        for (const Column& column : table.columns) {
            if (!column.meanings.empty()) {
                enumerations[column.name] = column.meanings;
            }
        }
    }
    std::vector<std::string_view> planes;
    for (const Named<geometry::ClipPlane>& plane : names<geometry::ClipPlane>()) {
        planes.push_back(plane.name);
    }
    enumerations["triangle.clip_planes"] = planes; // bit 0 is the first
    return enumerations;
}

Result<std::string> read_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    if (!file || !content) {
        return Diagnostic{
            .file = path.string(), .message = "belongs into the trace and cannot be read"};
    }
    return std::move(content).str();
}

/// The files of a recording on their way into the archive.
class FileMembers {
public:
    explicit FileMembers(const scene::Scene& scene) : folder_(fs::path(scene.file).parent_path()) {}

    /// Empty when all is well; a file named twice is kept once.
    Diagnostics add(const fs::path& path) {
        std::error_code error;
        if (!seen_.insert(fs::weakly_canonical(path, error)).second) {
            return {};
        }
        Result<std::string> text = read_file(path);
        if (!text) {
            return text.diagnostics();
        }
        const std::string reference = path.lexically_relative(folder_).generic_string();
        // Nothing may unpack outside of files/
        const bool below = !reference.empty() && !reference.starts_with("..");
        const std::string member =
            below ? "files/" + reference
                  : fmt::format("files/outside/{}/{}", seen_.size(), path.filename().string());
        list_.push_back({{"member", member}, {"reference", reference}, {"digest", digest_of(*text)}}
        );
        members_.push_back(text_member(member, std::move(*text)));
        return {};
    }

    [[nodiscard]] const ordered_json& list() const { return list_; }
    [[nodiscard]] std::vector<Member>& members() { return members_; }

private:
    fs::path folder_;
    std::set<fs::path> seen_;
    ordered_json list_ = ordered_json::array();
    std::vector<Member> members_;
};

ordered_json scene_json(const scene::Scene& scene, std::span<const scene::Assignment> assignments) {
    ordered_json changes = ordered_json::array();
    for (const scene::Assignment& assignment : assignments) {
        changes.push_back({{"path", assignment.path}, {"value", assignment.value}});
    }
    return {
        {"name", scene.name},
        {"file", "files/" + fs::path(scene.file).filename().string()},
        {"set", changes}};
}

ordered_json manifest_of(const Recording& recording) {
    ordered_json manifest;
    manifest["format"] = "halfspace trace";
    manifest["format_version"] = format_version;
    manifest["program_version"] = program_version();
    manifest["determinism"] = determinism_tag;
    manifest["settings"] = settings_json(recording.settings());
    manifest["steps"] = recording.end_step + 1;
    manifest["counters"] = counters_json(recording.counters);
    manifest["digests"] = {{"framebuffer", hex(recording.digest())}};
    manifest["objects"] = objects_json(recording);
    return manifest;
}

} // namespace

Result<Done> save_trace(
    const std::shared_ptr<const Recording>& recording,
    const fs::path& path,
    std::span<const scene::Assignment> assignments
) {
    const scene::Scene& scene = recording->scene();
    ordered_json manifest = manifest_of(*recording);
    FileMembers files(scene);
    if (!scene.file.empty()) {
        manifest["scene"] = scene_json(scene, assignments);
        if (Diagnostics problems = files.add(scene.file); !problems.empty()) {
            return problems;
        }
    }
    for (const std::string& file : scene.files) {
        if (Diagnostics problems = files.add(file); !problems.empty()) {
            return problems;
        }
    }
    manifest["files"] = files.list();

    const std::vector<Table> tables = trace_tables(recording);
    manifest["enumerations"] = enumerations_json(tables);
    std::vector<Member> members{text_member("manifest.json", manifest.dump(2) + '\n')};
    for (const Table& table : tables) {
        add_columns(members, table);
    }
    for (Member& file : files.members()) {
        members.push_back(std::move(file));
    }
    return write_archive(path, members);
}

} // namespace hs::exporting
