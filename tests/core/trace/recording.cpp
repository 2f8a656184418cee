#include "core/trace/history.hpp"
#include "core/trace/outline.hpp"
#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/fresh_run.hpp"
#include "tests/support/made_scene.hpp"
#include "tests/support/random_scene.hpp"

#include <limits>

using namespace hs;

TEST_CASE("an empty scene has a start, an end and nothing between", "[trace]") {
    auto scene = std::make_shared<scene::Scene>();
    const auto recording = trace::record(scene).value();
    CHECK(recording->end_step == 1);
    trace::Player player(recording);
    CHECK(player.current().kind == trace::StepKind::end);
    for (int g = 0; g < 6; ++g) {
        player.seek(0);
        player.advance(static_cast<trace::Granularity>(g), trace::Direction::forward);
        CHECK(player.step() == 1);
        CHECK_FALSE(player.find_stage(trace::Stage::test, trace::Direction::backward));
        player.advance(static_cast<trace::Granularity>(g), trace::Direction::backward);
        CHECK(player.step() == 0);
    }
}

TEST_CASE("the number of steps has a closed form for one triangle", "[trace]") {
    auto scene = tests::clip_space_scene(
        {{-1.0F, -1.0F, 0.0F, 1.0F}, {1.0F, -1.0F, 0.0F, 1.0F}, {-1.0F, 1.0F, 0.0F, 1.0F}}, 4, 4
    );
    scene->settings.traversal = scene::TraversalKind::brute_force;
    const auto recording = trace::record(scene).value();

    // The hypotenuse runs through pixel centers; it is neither a top nor a left edge, so its ties
    // are not covered
    const std::uint64_t covered = 6;
    CHECK(recording->counters.fragments == covered);
    const std::uint64_t start = 1;
    const std::uint64_t vertices = 3 * 3;
    const std::uint64_t geometry = 5; // outcodes, divide, viewport, cull, setup
    const std::uint64_t visits = 4 * 4;
    const std::uint64_t fragments = covered * 4; // interpolate, shade, depth test, merge
    CHECK(recording->end_step == start + vertices + geometry + visits + fragments);
}

TEST_CASE("a large triangle is indexed inside, so no re-run is longer than a row", "[trace]") {
    const auto scene = tests::stacked_scene(1, 700, 700);
    const auto recording = trace::record(scene).value();
    CHECK(recording->end_step > 2'000'000);
    const std::size_t longest_row = 700 * 5;
    for (std::size_t entry = 0; entry < recording->index.size(); entry += 97) {
        CHECK(trace::outline(*recording, entry).steps.size() <= 2048 + longest_row);
    }
    trace::Player player(recording);
    player.seek(1'000'001);
    CHECK(player.step() == 1'000'001);
    CHECK(player.current().in_triangle());
}

TEST_CASE("checkpoints keep to their budget by doubling their spacing", "[trace]") {
    const auto scene = tests::stacked_scene(64, 64, 64);
    const std::size_t one = 64 * 64 * sizeof(trace::PixelRecord);
    const trace::RecordOptions options{.checkpoint_budget = 6 * one, .checkpoint_spacing = 4096};
    const auto recording = trace::record(scene, options).value();
    REQUIRE(recording->fragments.size() == std::size_t{64} * 64 * 64);
    CHECK(recording->checkpoints.size() <= 6);
    CHECK(recording->checkpoints.size() >= 3);
    for (std::size_t i = 1; i < recording->checkpoints.size(); ++i) {
        CHECK(recording->checkpoints[i].fragments > recording->checkpoints[i - 1].fragments);
    }
    const auto none = trace::record(scene, {.checkpoint_budget = one / 2}).value();
    CHECK(none->checkpoints.empty());

    trace::Player sparse(none);
    trace::Player dense(recording);
    tests::Random random(1);
    for (int i = 0; i < 60; ++i) {
        const trace::StepId step = random.next() % (recording->end_step + 1);
        sparse.seek(step);
        dense.seek(step);
        REQUIRE(tests::shown_digest(sparse) == tests::shown_digest(dense));
    }
}

TEST_CASE("counts stay exact beyond what sixteen bits hold", "[trace]") {
    constexpr int layers = 70'000;
    auto scene = tests::stacked_scene(layers, 1, 1);
    scene->settings.depth_test_choice = scene::CompareOp::always;
    const auto recording = trace::record(scene).value();
    trace::Player player(recording);
    CHECK(player.pixel({0, 0}).complexity == std::numeric_limits<std::uint16_t>::max());
    CHECK(player.complexity({0, 0}) == layers);
    CHECK(player.overdraw({0, 0}) == layers);

    // Back across the limit and forth again
    player.seek(trace::last_step_of_triangle(*recording, 65'540));
    CHECK(player.complexity({0, 0}) == 65'541);
    for (int i = 0; i < 12; ++i) {
        player.advance(trace::Granularity::triangle, trace::Direction::backward);
    }
    CHECK(player.complexity({0, 0}) == 65'529);
    CHECK(player.pixel({0, 0}).overdraw == 65'529);
    for (int i = 0; i < 12; ++i) {
        player.advance(trace::Granularity::triangle, trace::Direction::forward);
    }
    CHECK(player.overdraw({0, 0}) == 65'541);
}

TEST_CASE("a long history keeps its latest rows and says how many it left out", "[trace]") {
    const auto recording = trace::record(tests::stacked_scene(50, 2, 2)).value();
    const trace::PixelHistory all = trace::pixel_history(*recording, {1, 1});
    const trace::PixelHistory some = trace::pixel_history(*recording, {1, 1}, 8);
    REQUIRE(all.rows.size() == 50);
    REQUIRE(some.rows.size() == 8);
    CHECK(some.left_out == 42);
    for (std::size_t i = 0; i < 8; ++i) {
        CHECK(some.rows[i].fragment == all.rows[42 + i].fragment);
        CHECK(some.rows[i].stored_depth == all.rows[42 + i].stored_depth);
        CHECK(some.rows[i].before == all.rows[42 + i].before);
    }
}

TEST_CASE("recording stops when asked and says so", "[trace]") {
    const auto scene = tests::stacked_scene(2, 4, 4);
    const auto stopped = trace::record(scene, {.progress = [](double) { return false; }});
    REQUIRE_FALSE(stopped);
    CHECK(stopped.diagnostics().front().message == "recording was stopped");
}

TEST_CASE("threads change time and nothing else", "[trace]") {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto scene = tests::random_scene(seed);
        const auto one = trace::record(scene, {.threads = 1}).value();
        const auto many = trace::record(scene, {.threads = 7}).value();
        CHECK(one->digest() == many->digest());
        CHECK(one->end_step == many->end_step);
    }
}

TEST_CASE("the strip's stages are found in both directions", "[trace]") {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        trace::Player player(trace::record(tests::random_scene(seed)).value());
        const trace::Recording& recording = player.recording();
        const trace::StepId last = std::min<trace::StepId>(recording.end_step - 1, 400);
        tests::Random random(seed);
        for (int i = 0; i < 10; ++i) {
            player.seek(random.next() % (last + 1));
            for (int s = 1; s < trace::stage_count; ++s) {
                const auto stage = static_cast<trace::Stage>(s);
                trace::StepId expected = player.step();
                while (expected > 0 &&
                       (expected == player.step() ||
                        trace::stage_of(trace::describe_step(recording, expected).kind) != stage)) {
                    --expected;
                }
                INFO("seed " << seed << ", from #" << player.step() << ", " << name_of(stage));
                const auto found = player.find_stage(stage, trace::Direction::backward);
                CHECK(found.value_or(0) == expected);
            }
        }
    }
}
