// Where the painter's algorithm may be wrong, and where it must be right.
#include "core/pipeline/window_polygons.hpp"
#include "core/scene/scene_file.hpp"
#include "core/trace/history.hpp"
#include "core/trace/recording.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_scene.hpp"

#include <algorithm>
#include <map>
#include <set>

using namespace hs;

namespace {

/// Nearest and farthest depth of a triangle as it is seen.
struct DepthExtent {
    double nearest = 0.0;
    double farthest = 0.0;
};

std::map<std::uint32_t, DepthExtent> depth_extents(const pipeline::Frame& frame) {
    std::map<std::uint32_t, DepthExtent> extents;
    for (const auto& polygon : pipeline::window_polygons(frame).polygons) {
        DepthExtent extent{2.0, -1.0};
        for (const auto& corner : polygon.corners) {
            extent.nearest = std::min(extent.nearest, corner.position.z);
            extent.farthest = std::max(extent.farthest, corner.position.z);
        }
        extents[polygon.triangle] = extent;
    }
    return extents;
}

std::shared_ptr<const trace::Recording>
recorded(const scene::Scene& original, scene::Visibility visibility, scene::PaintersKey key) {
    auto variant = std::make_shared<scene::Scene>(original);
    variant->settings.visibility = visibility;
    variant->settings.painters_key = key;
    auto recording = trace::record(variant);
    REQUIRE(recording);
    return *recording;
}

/// A scene in which a z-buffer is right: nothing blends, nothing changes its test.
std::shared_ptr<scene::Scene> opaque_scene(std::uint64_t seed) {
    auto scene = std::make_shared<scene::Scene>(*tests::random_scene(seed));
    scene->settings.clip_enabled = true;
    scene->settings.blend_enabled = false;
    scene->settings.depth_test_choice.reset();
    scene->settings.depth_write = true;
    scene->settings.depth_format = scene::DepthFormat::float32;
    for (scene::Object& object : scene->objects) {
        object.overrides.clear();
    }
    return scene;
}

bool apart(const DepthExtent& a, const DepthExtent& b) {
    constexpr double rounding = 1e-5; // of interpolated depths
    return a.farthest + rounding < b.nearest || b.farthest + rounding < a.nearest;
}

/// Whether the extents in depth of everything that covers a pixel keep apart.
bool is_decided(
    const trace::Recording& recording,
    PixelPos pixel,
    const std::map<std::uint32_t, DepthExtent>& extents
) {
    std::vector<DepthExtent> seen;
    for (const trace::HistoryRow& row : trace::pixel_history(recording, pixel).rows) {
        const auto found = extents.find(row.frame_triangle);
        if (found == extents.end()) {
            return false; // drawn by exact planes where the snapped polygon is edge-on
        }
        for (const DepthExtent& other : seen) {
            if (!apart(found->second, other)) {
                return false;
            }
        }
        seen.push_back(found->second);
    }
    return seen.size() > 1;
}

} // namespace

TEST_CASE(
    "painter's shows what a z-buffer shows wherever extents in depth keep apart",
    "[property][visibility]"
) {
    int decided = 0;
    int wrong = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        const auto scene = opaque_scene(seed);
        const auto key = static_cast<scene::PaintersKey>(seed % 3);
        const auto reference = recorded(*scene, scene::Visibility::z_buffer, key);
        const auto painted = recorded(*scene, scene::Visibility::painters, key);
        const auto extents = depth_extents(*painted->frame);
        painted->final_pixels.for_each([&](PixelPos p, const trace::PixelRecord& pixel) {
            const bool same = pixel.triangle == reference->final_pixels[p].triangle;
            wrong += same ? 0 : 1;
            if (is_decided(*painted, p, extents)) {
                ++decided;
                INFO("seed " << seed << ", pixel " << p.x << ',' << p.y);
                REQUIRE(same);
            }
        });
    }
    CHECK(decided > 500);
    CHECK(wrong > 500); // the claim is not empty: elsewhere it is wrong often enough
}

TEST_CASE("each short triangle fools exactly the key it is named after", "[visibility]") {
    const auto scene = scene::load_scene(test::source_dir() / "lessons/scenes/long-and-short.toml");
    REQUIRE(scene);
    for (const Named<scene::PaintersKey>& key : names<scene::PaintersKey>()) {
        const auto reference = recorded(*scene, scene::Visibility::z_buffer, key.value);
        const auto painted = recorded(*scene, scene::Visibility::painters, key.value);
        std::set<std::string> fooled;
        painted->final_pixels.for_each([&](PixelPos p, const trace::PixelRecord& pixel) {
            const std::uint32_t right = reference->final_pixels[p].triangle;
            if (pixel.triangle != right) {
                fooled.insert(scene->objects[std::max(pixel.triangle, right)].name);
            }
        });
        CHECK(fooled == std::set<std::string>{"fools " + std::string{key.name}});
    }
}

TEST_CASE("no key paints a cycle or crossing triangles right", "[visibility]") {
    for (const char* const name : {"three-triangle-cycle.toml", "crossing-triangles.toml"}) {
        const auto scene = scene::load_scene(test::source_dir() / "lessons/scenes" / name);
        REQUIRE(scene);
        for (const Named<scene::PaintersKey>& key : names<scene::PaintersKey>()) {
            const auto reference = recorded(*scene, scene::Visibility::z_buffer, key.value);
            const auto painted = recorded(*scene, scene::Visibility::painters, key.value);
            int wrong = 0;
            painted->final_pixels.for_each([&](PixelPos p, const trace::PixelRecord& pixel) {
                wrong += pixel.triangle == reference->final_pixels[p].triangle ? 0 : 1;
            });
            INFO(name << ", " << key.name);
            CHECK(wrong > 10);
        }
    }
}
