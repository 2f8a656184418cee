// Traces are opened again by libzip and by NumPy.
#include "core/export/trace_file.hpp"

#include "core/export/npz.hpp"
#include "core/scene/scene_file.hpp"
#include "tests/export/numpy.hpp"
#include "tests/export/recorded.hpp"
#include "tests/export/temporary_folder.hpp"
#include "tests/support/paths.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <zip.h>

#include <cstring>
#include <map>

using namespace hs;
using tests::TemporaryFolder;

namespace {

/// Every member of an archive, none of them compressed.
std::map<std::string, std::string> members_of(const std::filesystem::path& path) {
    int code = 0;
    zip_t* zip = zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code);
    REQUIRE(zip != nullptr);
    std::map<std::string, std::string> members;
    for (zip_int64_t i = 0; i < zip_get_num_entries(zip, 0); ++i) {
        zip_stat_t stat;
        REQUIRE(zip_stat_index(zip, static_cast<zip_uint64_t>(i), 0, &stat) == 0);
        CHECK(stat.comp_method == ZIP_CM_STORE);
        std::string content(stat.size, '\0');
        zip_file_t* file = zip_fopen_index(zip, static_cast<zip_uint64_t>(i), 0);
        CHECK(zip_fread(file, content.data(), stat.size) == static_cast<zip_int64_t>(stat.size));
        CHECK(zip_fclose(file) == 0); // checks the CRC
        members[stat.name] = content;
    }
    zip_discard(zip);
    return members;
}

/// The values behind an array's header.
template <typename T>
std::vector<T> values_of(const std::string& member) {
    const std::size_t header = 10 + static_cast<unsigned char>(member.at(8)) +
                               256U * static_cast<unsigned char>(member.at(9));
    std::vector<T> values((member.size() - header) / sizeof(T));
    if (!values.empty()) { // an empty vector may have no storage to point at
        std::memcpy(values.data(), member.data() + header, values.size() * sizeof(T));
    }
    return values;
}

constexpr std::string_view scene_text = R"(
[settings]
size = [24, 16]
[camera]
projection = { kind = "perspective", fov_y = 60.0, near = 1.0, far = 10.0 }
[[object]]
mesh = "parts/triangle.obj"
[[object]]
vertices = [[-1, 0, 2.5], [1, 0, 0], [0, 1, 0]]
polygons = [[0, 1, 2]]
)";

std::filesystem::path write_scene(const TemporaryFolder& folder) {
    const auto mesh = folder.write("parts/triangle.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
    return folder.write("scene.toml", scene_text);
}

std::shared_ptr<const trace::Recording> record_scene(
    const std::filesystem::path& file, std::span<const scene::Assignment> assignments = {}
) {
    auto scene = scene::load_scene(file, assignments);
    REQUIRE(scene);
    return tests::recorded(std::make_shared<scene::Scene>(std::move(*scene)));
}

} // namespace

TEST_CASE("a trace keeps every fact of a frame", "[export][trace-file]") {
    const TemporaryFolder folder;
    for (std::uint64_t seed = 0; seed < tests::random_frames; ++seed) {
        INFO("random scene " << seed);
        const auto recording = tests::recorded(tests::random_scene(seed));
        REQUIRE(exporting::save_trace(recording, folder / "a.npz"));
        const auto members = members_of(folder / "a.npz");

        const auto depth = values_of<float>(members.at("fragment.depth.npy"));
        const auto stored = values_of<float>(members.at("fragment.stored_depth.npy"));
        const auto color = values_of<float>(members.at("fragment.color.npy"));
        const auto fate = values_of<std::uint8_t>(members.at("fragment.fate.npy"));
        REQUIRE(depth.size() == recording->fragments.size());
        int wrong = 0;
        for (std::uint32_t i = 0; i < depth.size(); ++i) {
            const trace::FragmentRecord& fragment = recording->fragments[i];
            const float blue = recording->float_color() ? recording->color32f[i].b
                                                        : framebuffer::unpack(fragment.color).b;
            const bool right = depth[i] == fragment.depth &&
                               stored[i] == trace::pixel_before(*recording, i).depth &&
                               color[4 * std::size_t{i} + 2] == blue &&
                               fate[i] == static_cast<std::uint8_t>(fragment.fate);
            wrong += right ? 0 : 1;
        }
        CHECK(wrong == 0);

        const auto steps = values_of<std::uint64_t>(members.at("triangle.first_step.npy"));
        REQUIRE(steps.size() == recording->triangles.size());
        for (std::size_t t = 0; t < steps.size(); ++t) {
            CHECK(steps[t] == recording->triangles[t].first_step);
        }
        const auto runs = values_of<std::uint64_t>(members.at("run.first_fragment.npy"));
        CHECK(runs.size() == recording->runs.size());
    }
}

TEST_CASE(
    "a trace carries its scene, its files and how the scene was changed", "[export][trace-file]"
) {
    const TemporaryFolder folder;
    const auto file = write_scene(folder);
    const std::vector<scene::Assignment> changes{{"depth.test", "always"}};
    const auto recording = record_scene(file, changes);
    REQUIRE(exporting::save_trace(recording, folder / "a.npz", changes));

    const auto members = members_of(folder / "a.npz");
    CHECK(members.at("files/scene.toml") == scene_text);
    CHECK(
        members.at("files/parts/triangle.obj") == tests::read_text(folder / "parts/triangle.obj")
    );
    const auto manifest = nlohmann::json::parse(members.at("manifest.json"));
    CHECK(manifest["format_version"] == 1);
    CHECK(manifest["scene"]["file"] == "files/scene.toml");
    CHECK(manifest["scene"]["set"][0]["path"] == "depth.test");
    CHECK(manifest["settings"]["depth.test"] == "\"always\"");
    CHECK(manifest["files"].size() == 2);
    CHECK(manifest["digests"]["framebuffer"] == fmt::format("{:016x}", recording->digest()));
    CHECK(manifest["counters"]["fragments"] == recording->counters.fragments);
    CHECK(manifest["enumerations"]["fragment.fate"][0] == "written");
    CHECK(manifest["objects"][1]["first_vertex"] == 3);
}

TEST_CASE("what a trace carries is enough to record the same frame again", "[export][trace-file]") {
    const TemporaryFolder folder;
    const std::vector<scene::Assignment> changes{{"camera.eye", "[0.5, 0, 3]"}};
    const auto recording = record_scene(write_scene(folder), changes);
    REQUIRE(exporting::save_trace(recording, folder / "a.npz", changes));

    const TemporaryFolder elsewhere;
    const auto members = members_of(folder / "a.npz");
    for (const auto& [name, content] : members) {
        if (name.starts_with("files/")) {
            const auto written = elsewhere.write(name, content);
        }
    }
    const auto manifest = nlohmann::json::parse(members.at("manifest.json"));
    std::vector<scene::Assignment> again;
    for (const auto& change : manifest["scene"]["set"]) {
        again.push_back({change["path"], change["value"]});
    }
    const std::string file = manifest["scene"]["file"];
    CHECK(record_scene(elsewhere / file, again)->digest() == recording->digest());
}

TEST_CASE("equal recordings make equal traces", "[export][trace-file]") {
    const TemporaryFolder folder;
    const auto file = write_scene(folder);
    REQUIRE(exporting::save_trace(record_scene(file), folder / "a.npz"));
    REQUIRE(exporting::save_trace(record_scene(file), folder / "b.npz"));
    CHECK(tests::read_text(folder / "a.npz") == tests::read_text(folder / "b.npz"));
}

TEST_CASE("a trace whose mesh has vanished is refused and not begun", "[export][trace-file]") {
    const TemporaryFolder folder;
    const auto recording = record_scene(write_scene(folder));
    const auto mesh = folder / "parts/triangle.obj";
    std::filesystem::remove(mesh);
    const Result<Done> saved = exporting::save_trace(recording, folder / "a.npz");
    REQUIRE_FALSE(saved);
    CHECK(
        saved.diagnostics().front().to_string() ==
        mesh.string() + ": belongs into the trace and cannot be read"
    );
    CHECK(folder.names() == std::vector<std::string>{"parts", "scene.toml"});
}

TEST_CASE("NumPy opens a trace and finds words for its numbers", "[export][trace-file][npz]") {
    const auto python = tests::python_with_numpy();
    if (!python) {
        return;
    }
    const TemporaryFolder folder;
    const auto recording = record_scene(write_scene(folder));
    REQUIRE(exporting::save_trace(recording, folder / "a.npz"));
    CHECK(
        tests::run_numpy(
            *python,
            folder / "a.npz",
            "print(len(t['fragment.depth']), t['vertex.clip'].shape, t['vertex.clip'].dtype)\n"
            "print(t['fragment.fate.names'][t['fragment.fate']][0])\n"
            "print(t['triangle.verdict.names'][t['triangle.verdict']])\n"
            "print(np.isnan(t['vertex.ndc']).any(axis=1).sum() == (t['vertex.clip'][:, 3] <= "
            "0).sum())"
        ) ==
        fmt::format(
            "{} (6, 4) float32\nwritten\n['drawn' 'drawn']\nTrue\n", recording->fragments.size()
        )
    );
}
