// Any text as a scene file: it is refused with located reasons, or it can be recorded.
#include "core/scene/scene_file.hpp"
#include "core/trace/recording.hpp"
#include "tests/fuzz/claims.hpp"
#include "tests/fuzz/target.hpp"

#include <cctype>
#include <cstdint>
#include <memory>
#include <set>
#include <string_view>

using namespace hs;

namespace {

/// Numbers of six digits and more may ask for large shapes and images, which are allowed but slow.
bool has_large_number(std::string_view text) {
    int digits = 0;
    for (const char c : text) {
        if (c == '_') {
            continue;
        }
        digits = std::isxdigit(static_cast<unsigned char>(c)) != 0 ? digits + 1 : 0;
        if (digits > 5) {
            return true;
        }
    }
    return false;
}

void check_scene(const scene::Scene& scene) {
    HS_CHECK(scene.settings.width >= 1 && scene.settings.width <= 8192, "widths are bounded");
    HS_CHECK(scene.settings.height >= 1 && scene.settings.height <= 8192, "heights are bounded");
    HS_CHECK(!scene::check_combination(scene.settings), "settings go together");
    std::set<const scene::Mesh*> checked;
    for (const scene::Object& object : scene.objects) {
        HS_CHECK(object.mesh != nullptr, "an object has a mesh");
        HS_CHECK(!object.material || *object.material < scene.materials.size(), "it exists");
        if (checked.insert(object.mesh.get()).second) {
            fuzz::check_mesh(*object.mesh);
        }
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t most_triangles = 300;
    constexpr int most_pixels = 1024;
    const std::string_view text{reinterpret_cast<const char*>(data), size};
    if (has_large_number(text)) {
        return 0;
    }
    auto scene = scene::parse_scene(text, "fuzz.toml");
    if (!scene) {
        fuzz::check_diagnostics(scene.diagnostics(), text);
        return 0;
    }
    check_scene(*scene);
    const bool small = scene::triangle_count(*scene) <= most_triangles &&
                       scene->settings.width * scene->settings.height <= most_pixels;
    if (small) {
        const auto recording = trace::record(std::make_shared<scene::Scene>(std::move(*scene)));
        HS_CHECK(recording, "what was accepted can be recorded");
    }
    return 0;
}
