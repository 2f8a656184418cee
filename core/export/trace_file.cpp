#include "core/export/trace_file.hpp"

#include "core/base/hash.hpp"
#include "core/base/version.hpp"
#include "core/export/npz.hpp"
#include "core/export/table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <set>

namespace hs::exporting {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr int format_version = 1;

/// Recordings of builds with the same tag are bit-identical. It names the arithmetic, not the
/// machine.
constexpr std::string_view determinism_tag = "24.8 fixed, float32, no contraction";

ordered_json settings_json(const scene::Settings& settings) {
    ordered_json result;
    for (const scene::SettingInfo& info : scene::setting_infos()) {
        result[std::string{info.key}] = scene::print_setting(settings, info.key);
    }
    return result;
}

ordered_json counters_json(const Table& counters) {
    ordered_json result;
    for (const Column& column : counters.columns) {
        std::uint64_t value = 0;
        column.read(0, &value);
        result[column.name.substr(column.name.find('.') + 1)] = value;
    }
    return result;
}

/// The names behind every column of enumerators.
void add_enumerations(ordered_json& enumerations, const Table& table) {
    for (const Column& column : table.columns) {
        if (!column.meanings.empty()) {
            enumerations[column.name] = column.meanings;
        }
    }
}

std::string file_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string hex(std::uint64_t value) {
    return fmt::format("{:016x}", value);
}

/// The scene and what it refers to, verbatim under files/. Two files of one name in different
/// folders are told apart by a number.
Result<std::vector<Member>> file_members(const scene::Scene& scene, ordered_json& manifest) {
    std::vector<Member> members;
    std::set<std::string> taken;
    std::vector<std::string> sources = scene.files;
    if (!scene.file.empty()) {
        sources.insert(sources.begin(), scene.file);
    }
    for (const std::string& source : sources) {
        const std::string name = fs::path(source).filename().string();
        std::string member = "files/" + name;
        for (int i = 2; !taken.insert(member).second; ++i) {
            member = fmt::format("files/{}-{}", i, name);
        }
        Result<Member> file = file_member(member, source);
        if (!file) {
            return file.diagnostics();
        }
        const std::string text = file_text(source);
        Digest digest;
        digest.add_bytes(std::as_bytes(std::span{text.data(), text.size()}));
        manifest["files"].push_back({{"name", member}, {"digest", hex(digest.value())}});
        members.push_back(std::move(*file));
    }
    return members;
}

} // namespace

Result<Done>
save_trace(const std::shared_ptr<const trace::Recording>& recording, const fs::path& path) {
    ordered_json manifest;
    manifest["format"] = "halfspace trace";
    manifest["format_version"] = format_version;
    manifest["program_version"] = program_version();
    manifest["determinism"] = determinism_tag;
    manifest["scene"] = {
        {"name", recording->scene().name},
        {"file", fs::path(recording->scene().file).filename().string()}};
    manifest["settings"] = settings_json(recording->settings());
    manifest["files"] = ordered_json::array();

    Result<std::vector<Member>> members = file_members(recording->scene(), manifest);
    if (!members) {
        return members.diagnostics();
    }
    manifest["enumerations"] = ordered_json::object();
    for (const char* name :
         {"vertices", "triangles", "pieces", "piece-vertices", "runs", "fragments"}) {
        const Table table = make_table(recording, name).value();
        add_enumerations(manifest["enumerations"], table);
        for (const Column& column : table.columns) {
            members->push_back(column_member(column, table.rows));
        }
    }
    manifest["counters"] = counters_json(make_table(recording, "counters").value());
    manifest["digests"] = {{"framebuffer", hex(recording->digest())}};
    members->insert(members->begin(), text_member("manifest.json", manifest.dump(2) + '\n'));
    return write_archive(path, std::move(*members));
}

} // namespace hs::exporting
