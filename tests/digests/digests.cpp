// Prints one line per digest, `name value`. The lines must not depend on the compiler or its
// optimization level.
#include "core/base/hash.hpp"
#include "core/pipeline/draw_frame.hpp"
#include "core/scene/scene_file.hpp"
#include "core/scene/shapes.hpp"
#include "core/trace/recording.hpp"
#include "tests/support/random_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

using namespace hs;

namespace {

/// Products and sums as interpolation has them: a fused multiply-add would change the digest.
std::uint64_t arithmetic_digest() {
    Digest digest;
    float value = 0.1F;
    for (int i = 1; i < 1000; ++i) {
        const float weight = 1.0F / static_cast<float>(i);
        value = value * weight + (1.0F - weight) * 0.7F;
        digest.add(value);
    }
    return digest.value();
}

std::uint64_t mesh_digest(const scene::Mesh& mesh) {
    Digest digest;
    for (const glm::vec4& p : mesh.positions) {
        for (const float coordinate : {p.x, p.y, p.z, p.w}) {
            digest.add(coordinate);
        }
    }
    for (const glm::vec3& n : mesh.normals) {
        for (const float coordinate : {n.x, n.y, n.z}) {
            digest.add(coordinate);
        }
    }
    for (const scene::TriangleIndices& triangle : mesh.triangles) {
        digest.add(triangle);
    }
    return digest.value();
}

std::uint64_t untraced_digest(const std::shared_ptr<const scene::Scene>& scene) {
    pipeline::Frame frame(scene);
    framebuffer::Framebuffer target(scene->settings);
    pipeline::NullTrace nothing;
    pipeline::draw_frame(frame, target, nothing);
    return target.digest();
}

/// Not the picture alone: every fragment, every triangle's verdict and place among the steps.
std::uint64_t facts_digest(const trace::Recording& recording) {
    Digest digest;
    digest.add(recording.digest());
    for (std::size_t i = 0; i < recording.fragments.size(); ++i) {
        const trace::FragmentRecord& fragment = recording.fragments[i];
        digest.add(fragment.x);
        digest.add(fragment.y);
        digest.add(fragment.depth);
        digest.add(fragment.color);
        digest.add(fragment.previous);
        digest.add(fragment.fate);
    }
    for (const trace::TriangleRecord& triangle : recording.triangles) {
        digest.add(triangle.first_step);
        digest.add(triangle.verdict);
    }
    digest.add(recording.end_step);
    return digest.value();
}

std::uint64_t recorded_digest(const std::shared_ptr<const scene::Scene>& scene) {
    const auto recording = trace::record(scene);
    return recording ? facts_digest(**recording) : 0;
}

void print(const std::string& name, std::uint64_t digest) {
    fmt::print("{} {:016x}\n", name, digest);
}

void print_scene(const std::string& name, const std::shared_ptr<const scene::Scene>& scene) {
    print(name + ".untraced", untraced_digest(scene));
    print(name + ".recorded", recorded_digest(scene));
}

/// A shape lit from the side, shiny so that shading takes powers.
std::shared_ptr<scene::Scene> lit_shape(std::string_view kind, scene::Shading shading) {
    auto mesh = scene::make_shape(kind, {.triangles = 2000});
    HS_CHECK(mesh, "a shape there is");
    auto scene = std::make_shared<scene::Scene>(scene::scene_of_mesh(std::move(*mesh)));
    scene->settings.width = 96;
    scene->settings.height = 72;
    scene->settings.shading = shading;
    scene->materials.push_back({.name = "shiny", .specular = glm::vec3{0.6F}, .shininess = 20.0F});
    scene->objects.front().material = scene->materials.size() - 1;
    return scene;
}

void print_shapes() {
    for (const std::string kind : {"plane", "cube", "sphere", "torus", "torus-knot", "teapot"}) {
        const auto gouraud = lit_shape(kind, scene::Shading::gouraud);
        print("mesh." + kind, mesh_digest(*gouraud->objects.front().mesh));
        print_scene("gouraud." + kind, gouraud);
        print_scene("phong." + kind, lit_shape(kind, scene::Shading::phong));
    }
}

/// Every setting in every combination that chance brings; a hundred scenes to a line.
void print_random_scenes(
    const std::string& kind, std::shared_ptr<const scene::Scene> (*scene_of)(std::uint64_t)
) {
    constexpr std::uint64_t scenes_per_line = 100;
    constexpr std::uint64_t lines = 10;
    for (std::uint64_t line = 0; line < lines; ++line) {
        Digest untraced;
        Digest recorded;
        for (std::uint64_t i = 0; i < scenes_per_line; ++i) {
            const auto scene = scene_of(line * scenes_per_line + i);
            untraced.add(untraced_digest(scene));
            recorded.add(recorded_digest(scene));
        }
        const std::string name = fmt::format("{}.{}", kind, line * scenes_per_line);
        print(name + ".untraced", untraced.value());
        print(name + ".recorded", recorded.value());
    }
}

/// The scenes that come with the program.
void print_scene_files() {
    std::vector<std::filesystem::path> files;
    const std::filesystem::path lessons = HALFSPACE_SOURCE_DIR "/lessons";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(lessons)) {
        if (entry.path().extension() == ".toml") {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    for (const std::filesystem::path& file : files) {
        auto scene = scene::load_scene(file);
        if (!scene) {
            fmt::print(stderr, "{}\n", scene.diagnostics().front().to_string());
            continue;
        }
        print_scene(
            "file." + file.stem().string(), std::make_shared<scene::Scene>(std::move(*scene))
        );
    }
}

} // namespace

int main() {
    print("arithmetic", arithmetic_digest());
    print_shapes();
    print_random_scenes("random", tests::random_scene);
    print_random_scenes("sampled", tests::sampled_scene);
    print_scene_files();
    return 0;
}
