// The first three promises of the architecture, over random scenes.
#include "core/pipeline/draw_frame.hpp"
#include "core/trace/history.hpp"
#include "core/trace/outline.hpp"
#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/fresh_run.hpp"
#include "tests/support/random_scene.hpp"

#include <algorithm>
#include <array>

using namespace hs;
using trace::Direction;
using trace::Granularity;

namespace {

constexpr std::uint64_t scenes = 100;
constexpr scene::Visibility ray_cast = scene::Visibility::ray_cast;

/// Every other one with several samples a pixel, or conservative.
std::shared_ptr<const scene::Scene> a_scene(std::uint64_t seed) {
    return seed % 2 == 0 ? tests::random_scene(seed / 2) : tests::sampled_scene(seed / 2);
}

std::shared_ptr<const trace::Recording> recorded(
    const std::shared_ptr<const scene::Scene>& scene, const trace::RecordOptions& options = {}
) {
    auto recording = trace::record(scene, options);
    REQUIRE(recording);
    return *recording;
}

/// A budget so small that checkpoints are made at every index entry and most must go again.
trace::RecordOptions tight_budget(const scene::Settings& settings) {
    return {.checkpoint_budget = 3 * trace::PixelBuffer(settings).bytes(), .checkpoint_spacing = 1};
}

} // namespace

TEST_CASE("a frame untraced, recorded and stepped is bit-identical", "[property][trace]") {
    for (std::uint64_t seed = 0; seed < 4 * scenes; ++seed) {
        const auto scene = a_scene(seed);
        pipeline::Frame frame(scene);
        framebuffer::Framebuffer untraced(scene->settings);
        pipeline::NullTrace nothing;
        pipeline::draw_frame(frame, untraced, nothing);
        framebuffer::Framebuffer on_threads(scene->settings);
        pipeline::draw_frame(frame, on_threads, nothing, 3);

        const auto recording = recorded(scene);
        trace::Player player(recording);
        INFO(scene->name);
        CHECK(recording->digest() == untraced.digest());
        CHECK(on_threads.digest() == untraced.digest());
        player.seek(0);
        while (player.advance(Granularity::fragment, Direction::forward)) {
        }
        CHECK(tests::shown_digest(player) == untraced.digest());
    }
}

TEST_CASE("any step equals a fresh run stopped there", "[property][trace]") {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        const auto scene = a_scene(seed);
        const std::vector<tests::Moment> moments = tests::fresh_run(scene);
        const auto recording = recorded(scene, tight_budget(scene->settings));
        INFO(scene->name);
        REQUIRE(recording->end_step + 1 == moments.size());

        trace::Player player(recording);
        tests::Random random(seed);
        for (int jump = 0; jump < 150; ++jump) {
            const trace::StepId step = random.next() % moments.size();
            player.seek(step);
            REQUIRE(player.step() == step);
            REQUIRE(player.current().kind == moments[step].kind);
            REQUIRE(tests::shown_digest(player) == moments[step].framebuffer);
            REQUIRE(player.counters() == moments[step].counters);
        }
    }
}

TEST_CASE("seeking, stepping and stepping back never leave the fresh run", "[property][trace]") {
    for (std::uint64_t seed = 100; seed < 100 + scenes; ++seed) {
        const auto scene = a_scene(seed);
        const std::vector<tests::Moment> moments = tests::fresh_run(scene);
        trace::Player player(recorded(scene, tight_budget(scene->settings)));
        tests::Random random(seed);
        INFO(scene->name);
        for (int move = 0; move < 150; ++move) {
            if (random.one_in(10)) {
                player.seek(random.next() % moments.size());
            } else {
                player.advance(
                    static_cast<Granularity>(random.below(6)),
                    random.one_in(2) ? Direction::forward : Direction::backward
                );
            }
            REQUIRE(tests::shown_digest(player) == moments[player.step()].framebuffer);
        }
    }
}

TEST_CASE("forward then back is the identity between unit ends", "[property][trace]") {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        trace::Player player(recorded(a_scene(seed)));
        for (int g = 0; g < 6; ++g) {
            const auto granularity = static_cast<Granularity>(g);
            INFO(name_of(granularity) << ", seed " << seed);
            player.seek(0);
            trace::StepId before = 0;
            for (int i = 0; i < 40 && player.advance(granularity, Direction::forward); ++i) {
                REQUIRE(player.step() > before);
                REQUIRE(player.target(granularity, Direction::backward) == before);
                before = player.step();
            }
        }
    }
}

TEST_CASE("targets equal a linear scan over every step", "[property][trace]") {
    const auto ends_unit = [](const trace::Recording& recording,
                              const trace::Step& s,
                              const trace::Step& next,
                              Granularity g) {
        if (recording.in_row(s.id) && g == Granularity::scanline) {
            return s.pixel.y != next.pixel.y || !recording.in_row(next.id);
        }
        if (recording.in_row(s.id) && recording.settings().visibility == ray_cast) {
            return s.pixel != next.pixel || !recording.in_row(next.id);
        }
        const bool in_unit = s.in_unit();
        const bool same_triangle =
            next.in_triangle() && s.object == next.object && s.triangle == next.triangle;
        const bool same_unit = in_unit && next.in_unit() && same_triangle &&
                               s.piece == next.piece && s.unit == next.unit;
        const bool same_fragment =
            s.in_fragment() && next.in_fragment() && s.fragment == next.fragment;
        const bool iteration =
            s.kind == trace::StepKind::order && s.decision == visibility::OrderEventKind::iteration;
        return g == Granularity::scanline   ? iteration || (in_unit && !same_unit)
               : g == Granularity::fragment ? s.in_fragment() && !same_fragment
                                            : false;
    };
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        trace::Player player(recorded(a_scene(seed)));
        const trace::Recording& recording = player.recording();
        std::vector<trace::Step> steps;
        for (trace::StepId i = 0; i <= std::min<trace::StepId>(recording.end_step, 1500); ++i) {
            steps.push_back(trace::describe_step(recording, i));
        }
        for (const Granularity g : {Granularity::scanline, Granularity::fragment}) {
            trace::StepId expected = 0;
            for (std::size_t i = 1; i + 1 < steps.size(); ++i) {
                if (!ends_unit(recording, steps[i], steps[i + 1], g)) {
                    continue;
                }
                INFO(name_of(g) << ", seed " << seed << ", step " << i);
                player.seek(expected);
                REQUIRE(player.target(g, Direction::forward) == i);
                player.seek(i);
                REQUIRE(player.target(g, Direction::backward) == expected);
                expected = i;
            }
        }
    }
}

TEST_CASE("a re-run reproduces what was recorded", "[property][trace]") {
    for (std::uint64_t seed = 0; seed < 4 * scenes; ++seed) {
        const auto recording = recorded(a_scene(seed));
        INFO("seed " << seed);
        trace::StepId next = recording->first_triangle_step;
        for (std::size_t entry = 0; entry < recording->index.size(); ++entry) {
            const trace::Outline window = trace::outline(*recording, entry);
            REQUIRE(window.divergences == 0);
            REQUIRE(window.first_step == next);
            next += window.steps.size();
        }
        REQUIRE(next == recording->first_resolve_step);
    }
}

TEST_CASE("what is shown for a fragment is what was executed", "[property][trace]") {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        const auto recording = recorded(a_scene(seed));
        INFO("seed " << seed);
        for (std::uint32_t i = 0; i < recording->fragments.size(); i += 7) {
            const trace::FragmentRecord& record = recording->fragments[i];
            const trace::FragmentDetail detail = trace::fragment_detail(*recording, i);
            REQUIRE(detail.fragment.pixel == record.pixel());
            REQUIRE(detail.fate == record.fate);
            REQUIRE(detail.merge.has_value() == record.written());
            if (detail.depth_test && recording->samples.active()) {
                const framebuffer::PixelSamples before = recording->samples.after(record.previous);
                REQUIRE(detail.depth_test->stored == before[detail.depth_test->sample].depth);
            } else if (detail.depth_test) {
                REQUIRE(detail.depth_test->depth == record.depth);
                REQUIRE(detail.depth_test->stored == trace::pixel_before(*recording, i).depth);
            }
            if (detail.merge) {
                REQUIRE(framebuffer::pack(detail.merge->after) == record.color);
            }
        }
    }
}

TEST_CASE("every step's path leads back to it", "[property][trace]") {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        const auto recording = recorded(a_scene(seed));
        tests::Random random(seed);
        for (int i = 0; i < 40; ++i) {
            const trace::StepId id = random.next() % (recording->end_step + 1);
            const std::string path = trace::step_path(trace::describe_step(*recording, id));
            INFO("seed " << seed << ", #" << id << ", " << path);
            const auto found = trace::find_step(*recording, path);
            REQUIRE(found);
            REQUIRE(*found == id);
        }
    }
}

TEST_CASE("a pixel's history tells what the framebuffer went through", "[property][trace]") {
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        trace::Player player(recorded(a_scene(seed)));
        const trace::Recording& recording = player.recording();
        tests::Random random(seed);
        const PixelPos pixel{
            static_cast<int>(random.below(static_cast<std::uint32_t>(recording.width()))),
            static_cast<int>(random.below(static_cast<std::uint32_t>(recording.height())))};
        const trace::PixelHistory history = trace::pixel_history(recording, pixel);
        INFO("seed " << seed << ", pixel " << pixel.x << ',' << pixel.y);
        player.seek(0);
        CHECK(player.color(pixel) == history.initial_color);
        CHECK(player.pixel(pixel).depth == history.initial_depth);
        for (const trace::HistoryRow& row : history.rows) {
            player.seek(trace::last_step_of_fragment(recording, row.fragment) - 1);
            REQUIRE(player.color(pixel) == row.before);
            REQUIRE(player.pixel(pixel).depth == row.stored_depth);
            player.seek(player.step() + 1);
            REQUIRE(player.color(pixel) == row.after);
        }
        player.seek(player.end());
        CHECK(player.color(pixel) == history.final_color);
        CHECK(player.pixel(pixel).depth == history.final_depth);
        CHECK(player.complexity(pixel) == history.rows.size());
    }
}
