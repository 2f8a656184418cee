#include "core/trace/quad_detail.hpp"

#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"

#include <algorithm>
#include <set>

using namespace hs;

namespace {

/// Every other one with several samples a pixel, or conservative; none homogeneous, whose varyings
/// come from planes through the eye; none that shows the nearest by rows, without blocks of pixels.
std::shared_ptr<const trace::Recording> a_recording(std::uint64_t seed) {
    auto scene = std::make_shared<scene::Scene>(
        *(seed % 2 == 0 ? tests::random_scene(seed / 2) : tests::sampled_scene(seed / 2))
    );
    if (scene->settings.traversal == scene::TraversalKind::homogeneous) {
        scene->settings.traversal = scene::TraversalKind::hierarchical;
    }
    if (scene->settings.sweeps()) {
        scene->settings.visibility = scene::Visibility::z_buffer;
    }
    return trace::record(std::move(scene)).value();
}

} // namespace

TEST_CASE("a fragment of a quad is the fragment that was drawn", "[property][trace]") {
    for (std::uint64_t seed = 0; seed < 80; ++seed) {
        trace::Player player(a_recording(seed));
        const trace::Recording& recording = player.recording();
        const bool per_sample = recording.settings().sampling == scene::Sampling::supersample;
        for (std::uint32_t i = 0; i < recording.fragments.size() && !per_sample; i += 11) {
            player.seek(trace::last_step_of_fragment(recording, i));
            const trace::StepDetail& detail = player.detail();
            const auto quad = trace::quad_detail(recording, *detail.triangle, player.current());
            INFO("seed " << seed << ", fragment " << i);
            REQUIRE(quad);
            const auto index =
                static_cast<std::size_t>(quad->quad.index(recording.fragments[i].pixel()));
            REQUIRE_FALSE(quad->quad.helper[index]);
            REQUIRE(quad->quad.fragments[index].depth == detail.fragment->fragment.depth);
            REQUIRE(quad->quad.fragments[index].varyings == detail.fragment->fragment.varyings);
        }
    }
}

TEST_CASE("covered pixels and helpers fill whole blocks of four", "[property][trace]") {
    for (std::uint64_t seed = 0; seed < 80; ++seed) {
        trace::Player player(a_recording(seed));
        const trace::Recording& recording = player.recording();
        for (const trace::Run& run : recording.runs) {
            player.seek(trace::last_step_of_fragment(recording, run.first_fragment));
            const auto helpers =
                trace::helper_pixels(recording, *player.detail().triangle, player.current());
            std::set<PixelPos> covered;
            const trace::Run* const next = &run + 1;
            const auto end = next == recording.runs.data() + recording.runs.size()
                                 ? static_cast<std::uint32_t>(recording.fragments.size())
                                 : next->first_fragment;
            for (std::uint32_t i = run.first_fragment; i < end; ++i) {
                covered.insert(recording.fragments[i].pixel());
            }
            INFO("seed " << seed << ", fragment " << run.first_fragment);
            REQUIRE(helpers.whole);
            REQUIRE(helpers.covered == covered.size());
            std::set<PixelPos> origins;
            for (const PixelPos pixel : covered) {
                origins.insert(raster::quad_origin(pixel));
            }
            REQUIRE(helpers.helpers.size() + covered.size() == 4 * origins.size());
            REQUIRE(std::ranges::none_of(helpers.helpers, [&](PixelPos pixel) {
                return covered.contains(pixel) || !origins.contains(raster::quad_origin(pixel));
            }));
        }
    }
}
