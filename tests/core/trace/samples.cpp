// Frames with several samples a pixel, step by step.
#include "core/explain/sentence.hpp"
#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random_scene.hpp"
#include "tests/support/soup_scene.hpp"

#include <bit>
#include <map>

using namespace hs;
using trace::StepKind;

namespace {

/// Two triangles over 4 × 3 pixels, the second nearer to the right.
std::shared_ptr<const scene::Scene> two_triangles(scene::Sampling sampling, int samples) {
    scene::Settings settings;
    settings.width = 4;
    settings.height = 3;
    settings.traversal = scene::TraversalKind::brute_force;
    settings.samples = samples;
    settings.sampling = sampling;
    const glm::vec4 red{1.0F, 0.0F, 0.0F, 1.0F};
    const glm::vec4 blue{0.0F, 0.0F, 1.0F, 1.0F};
    return tests::soup_scene(
        {{{-0.9F, -0.9F, 0.0F, 1.0F}, red},
         {{0.9F, -0.9F, 0.0F, 1.0F}, red},
         {{0.0F, 0.9F, 0.0F, 1.0F}, red},
         {{-0.9F, 0.8F, 0.5F, 1.0F}, blue},
         {{-0.2F, -0.9F, 0.5F, 1.0F}, blue},
         {{0.9F, 0.8F, -0.5F, 1.0F}, blue}},
        settings
    );
}

std::shared_ptr<const trace::Recording> recorded(const std::shared_ptr<const scene::Scene>& scene) {
    return trace::record(scene).value();
}

std::map<StepKind, int> count_kinds(const trace::Recording& recording) {
    std::map<StepKind, int> kinds;
    for (trace::StepId id = 0; id <= recording.end_step; ++id) {
        ++kinds[trace::describe_step(recording, id).kind];
    }
    return kinds;
}

} // namespace

TEST_CASE("every sample asked and every pixel resolved is a step", "[unit][trace]") {
    for (const int samples : {2, 4, 8}) {
        const auto recording = recorded(two_triangles(scene::Sampling::multisample, samples));
        auto kinds = count_kinds(*recording);
        CHECK(kinds[StepKind::sample_test] == 2 * 4 * 3 * samples);
        CHECK(kinds[StepKind::edge_test] == 0);
        CHECK(kinds[StepKind::resolve] == 4 * 3);
        int covered = 0;
        for (std::uint32_t i = 0; i < recording->fragments.size(); ++i) {
            covered += std::popcount(recording->fragments[i].coverage);
        }
        CHECK(kinds[StepKind::depth_test] == covered);
        CHECK(kinds[StepKind::shade] == static_cast<int>(recording->fragments.size()));
    }
}

TEST_CASE("supersampling makes a fragment of every covered sample", "[unit][trace]") {
    const auto once = recorded(two_triangles(scene::Sampling::multisample, 4));
    const auto each = recorded(two_triangles(scene::Sampling::supersample, 4));
    std::size_t covered = 0;
    for (std::uint32_t i = 0; i < once->fragments.size(); ++i) {
        covered += static_cast<std::size_t>(std::popcount(once->fragments[i].coverage));
    }
    CHECK(each->fragments.size() == covered);
    for (std::uint32_t i = 0; i < each->fragments.size(); ++i) {
        CHECK(std::popcount(each->fragments[i].coverage) == 1);
    }
    CHECK(count_kinds(*each)[StepKind::shade] == static_cast<int>(covered));
}

TEST_CASE("a path names a sample, its depth test, and a pixel's resolve", "[unit][trace]") {
    const auto recording = recorded(two_triangles(scene::Sampling::multisample, 4));
    const auto kind_at = [&](std::string_view path) {
        return trace::describe_step(*recording, trace::find_step(*recording, path).value());
    };
    const trace::Step test = kind_at("object 0 / triangle 1 / pixel 1,1 / sample 3");
    CHECK(test.kind == StepKind::sample_test);
    CHECK(test.sample == 3);
    CHECK(trace::step_path(test) == "object 0 / triangle 1 / pixel 1,1 / sample 3");
    const trace::Step depth =
        kind_at("object 0 / triangle 1 / fragment 1,1 / sample 1 / depth test");
    CHECK(depth.kind == StepKind::depth_test);
    CHECK(depth.sample == 1);
    const trace::Step resolve = kind_at("resolve / pixel 2,1");
    CHECK(resolve.kind == StepKind::resolve);
    CHECK(resolve.pixel == PixelPos{2, 1});
    CHECK(kind_at("resolve").pixel == PixelPos{3, 2});
}

TEST_CASE("paths to samples that do not exist are refused in a sentence", "[unit][trace]") {
    const auto sampled = recorded(two_triangles(scene::Sampling::multisample, 4));
    const auto centers = recorded(two_triangles(scene::Sampling::multisample, 1));
    CHECK(
        trace::find_step(*sampled, "resolve / pixel 4,0").diagnostics().front().message ==
        "the image has no pixel 4,0; it is 4 x 3 pixels"
    );
    CHECK(
        trace::find_step(*centers, "resolve").diagnostics().front().message ==
        "nothing is resolved in a frame with one sample a pixel"
    );
    CHECK_FALSE(trace::find_step(*sampled, "object 0 / triangle 0 / pixel 1,1 / sample 4"));
}

TEST_CASE("the samples shown at a step are those of the log", "[unit][trace]") {
    trace::Player player(recorded(two_triangles(scene::Sampling::multisample, 4)));
    const trace::Recording& recording = player.recording();
    for (std::uint32_t i = 0; i < recording.fragments.size(); ++i) {
        const trace::FragmentRecord& fragment = recording.fragments[i];
        player.seek(trace::last_step_of_fragment(recording, i));
        CHECK(player.samples(fragment.pixel()) == recording.samples.after(i));
        const std::vector<trace::SampleDetail>& samples = player.detail().samples;
        REQUIRE(samples.size() == 4);
        for (int s = 0; s < 4; ++s) {
            const trace::SampleDetail& sample = samples[static_cast<std::size_t>(s)];
            CHECK(sample.covered == raster::has_sample(fragment.coverage, s));
            CHECK(sample.passed == raster::has_sample(fragment.passed, s));
            CHECK((sample.before == sample.after || sample.passed));
            if (sample.passed) {
                CHECK(sample.after.depth == sample.depth);
            }
        }
    }
}

TEST_CASE("pixels are resolved one by one after the last triangle", "[unit][trace]") {
    trace::Player player(recorded(two_triangles(scene::Sampling::multisample, 2)));
    player.seek(player.recording().first_resolve_step - 1);
    CHECK_FALSE(player.resolved({0, 0}));
    player.seek(player.recording().first_resolve_step + 5);
    CHECK(player.resolved({1, 1}));
    CHECK_FALSE(player.resolved({2, 1}));
    CHECK(player.find_stage(trace::Stage::merge, trace::Direction::forward) == player.step() + 1);
    player.seek(player.end());
    CHECK(player.resolved({3, 2}));
}

TEST_CASE("every step of a sampled frame is told in a sentence", "[unit][explain]") {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        trace::Player player(recorded(tests::sampled_scene(seed)));
        tests::Random random(seed);
        for (int i = 0; i < 60; ++i) {
            player.seek(random.next() % (player.end() + 1));
            const std::string text = explain::sentence(player);
            INFO(trace::step_path(player.current()) << ": " << text);
            REQUIRE(text.size() > 10);
            REQUIRE(text.back() == '.');
            REQUIRE(text.find(trace::step_path(player.current())) == std::string::npos);
        }
    }
}
