// The playhead: stepping, jumping and asking for a pixel's history in a large recording.
//
// Budgets name the worst place, not the worst moment: every move is made five times, the median of
// its computing time counts, then the slowest move is reported. A move ends with what a person is
// shown: the framebuffer and the reasoning behind the step.
#include "app/bench/session.hpp"
#include "app/bench/timing.hpp"
#include "core/trace/history.hpp"
#include "core/trace/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>

namespace hs::bench {
namespace {

using trace::Direction;
using trace::Granularity;
using trace::Player;
using trace::StepId;

constexpr int repetitions = 5;

using Generator = std::mt19937_64; // no distribution of the library: the same everywhere

template <typename Prepare, typename Run>
double median_of_repetitions(Prepare&& prepare, Run&& run) {
    std::vector<double> times;
    for (int i = 0; i < repetitions; ++i) {
        prepare();
        times.push_back(computing_milliseconds(run));
    }
    return median(std::move(times));
}

StepId any_step(Generator& random, const trace::Recording& recording) {
    return random() % (recording.end_step + 1);
}

/// The slowest of some moves from places all over the frame, forward and back.
double slowest_step(Player& player, Granularity granularity) {
    constexpr int places = 24;
    Generator random(7);
    double slowest = 0.0;
    for (int i = 0; i < places; ++i) {
        const StepId from = any_step(random, player.recording());
        for (const Direction direction : {Direction::forward, Direction::backward}) {
            const double time = median_of_repetitions(
                [&] { player.seek(from); },
                [&] {
                    player.advance(granularity, direction);
                    static_cast<void>(player.detail());
                }
            );
            slowest = std::max(slowest, time);
        }
    }
    return slowest;
}

void measure_steps(Session& session) {
    const std::string name = "step.knot870k";
    if (!session.wants_any(name)) {
        return;
    }
    Player player(session.large_recording());
    double slowest = 0.0;
    std::string where;
    for (int g = 0; g < static_cast<int>(names<Granularity>().size()); ++g) {
        const auto granularity = static_cast<Granularity>(g);
        const std::string part = fmt::format("{}.{}", name, name_of(granularity));
        if (!session.wants(part) && !session.wants(name)) {
            continue;
        }
        session.progress(part);
        const double time = slowest_step(player, granularity);
        session.add({.name = part, .value = time, .unit = "ms", .budget = 1.0});
        if (time > slowest) {
            slowest = time;
            where = name_of(granularity);
        }
    }
    session.add(
        {.name = name,
         .value = slowest,
         .unit = "ms",
         .budget = 1.0,
         .note = fmt::format("the slowest granularity is {}", where)}
    );
}

/// Where jumps hurt most: half way between two kept framebuffers, far from both.
std::vector<StepId> hard_targets(const trace::Recording& recording) {
    std::vector<std::uint32_t> kept{0};
    for (const trace::Checkpoint& checkpoint : recording.checkpoints) {
        kept.push_back(checkpoint.fragments);
    }
    kept.push_back(static_cast<std::uint32_t>(recording.fragments.size()));
    std::vector<StepId> targets;
    for (std::size_t i = 0; i + 1 < kept.size(); ++i) {
        for (const std::uint32_t part : {1U, 2U, 3U}) {
            const std::uint32_t fragment = kept[i] + (kept[i + 1] - kept[i]) / 4 * part;
            targets.push_back(trace::last_step_of_fragment(recording, fragment));
        }
        targets.push_back(trace::last_step_of_fragment(recording, kept[i + 1] - 1));
    }
    return targets;
}

double slowest_jump(Player& player) {
    constexpr int places = 40;
    Generator random(11);
    const trace::Recording& recording = player.recording();
    std::vector<StepId> targets = hard_targets(recording);
    for (int i = 0; i < places; ++i) {
        targets.push_back(any_step(random, recording));
    }
    targets.push_back(0);
    targets.push_back(recording.end_step);
    double slowest = 0.0;
    for (const StepId to : targets) {
        const StepId from = any_step(random, recording);
        const double time = median_of_repetitions(
            [&] { player.seek(from); },
            [&] {
                player.seek(to);
                static_cast<void>(player.detail());
            }
        );
        slowest = std::max(slowest, time);
    }
    return slowest;
}

void report_jumps(
    Session& session, const std::string& name, const std::shared_ptr<const trace::Recording>& where
) {
    session.progress(name);
    Player player(where);
    session.add(
        {.name = name,
         .value = slowest_jump(player),
         .unit = "ms",
         .budget = 16.0,
         .note = fmt::format(
             "the slowest jump in {:.1f} million steps", static_cast<double>(where->end_step) / 1e6
         )}
    );
}

/// At least 100 million steps: instances of one knot, each turned a little further.
std::shared_ptr<const trace::Recording> hundred_million_steps(Session& session) {
    constexpr StepId wanted = 100'000'000;
    const StepId steps_of_one = session.large_recording()->end_step;
    const auto instances = static_cast<int>(wanted / steps_of_one + 1);
    auto scene = scene_of(session.knot870k(), full_hd);
    const scene::Object first = scene->objects.front();
    for (int i = 1; i < instances; ++i) {
        scene::Object turned = first;
        turned.transform.push_back(
            {.kind = scene::TransformStep::Kind::rotate,
             .vector = {0.0F, 1.0F, 0.0F},
             .degrees = 360.0F * static_cast<float>(i) / static_cast<float>(instances)}
        );
        scene->objects.push_back(std::move(turned));
    }
    return record(scene);
}

/// The slowest of the busiest pixel and a thousand others.
double slowest_history(const trace::Recording& recording) {
    std::vector<PixelPos> pixels;
    PixelPos busiest;
    recording.final_pixels.for_each([&](PixelPos p, const trace::PixelRecord& pixel) {
        if (pixel.complexity > recording.final_pixels[busiest].complexity) {
            busiest = p;
        }
    });
    pixels.push_back(busiest);
    Generator random(13);
    for (int i = 0; i < 1000; ++i) {
        const auto x = static_cast<int>(random() % static_cast<unsigned>(recording.width()));
        const auto y = static_cast<int>(random() % static_cast<unsigned>(recording.height()));
        pixels.push_back({x, y});
    }
    double slowest = 0.0;
    for (const PixelPos pixel : pixels) {
        const double time = median_of_repetitions(
            [] {}, [&] { static_cast<void>(trace::pixel_history(recording, pixel)); }
        );
        slowest = std::max(slowest, time);
    }
    return slowest;
}

void measure_histories(Session& session) {
    if (session.wants("history.knot870k")) {
        session.progress("history.knot870k");
        const double slowest = slowest_history(*session.large_recording());
        session.add({.name = "history.knot870k", .value = slowest, .unit = "ms", .budget = 1.0});
    }
    if (session.wants("history.4096-deep")) {
        session.progress("history.4096-deep");
        const auto deep = record(sheets(4096, {"32", 32, 32}));
        session.add(
            {.name = "history.4096-deep",
             .value = slowest_history(*deep),
             .unit = "ms",
             .budget = 1.0,
             .note = "4096 fragments at every pixel"}
        );
    }
}

} // namespace

void measure_playhead(Session& session) {
    measure_steps(session);
    if (session.wants("jump.knot870k.1080p")) {
        report_jumps(session, "jump.knot870k.1080p", session.large_recording());
    }
    measure_histories(session);
    if (session.wants("jump.100m-steps")) {
        session.progress("a recording of 100 million steps to jump in");
        report_jumps(session, "jump.100m-steps", hundred_million_steps(session));
    }
}

} // namespace hs::bench
