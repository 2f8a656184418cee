// Any sequence of seeks and steps, with next to no memory for checkpoints: the player always shows
// what a fresh run stopped there shows.
#include "tests/fuzz/bytes.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/support/fresh_run.hpp"
#include "tests/support/random_scene.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

using namespace hs;
using trace::Direction;
using trace::Granularity;

namespace {

constexpr std::size_t scenes = 64;
constexpr std::size_t budgets = 4;

struct Subject {
    std::vector<tests::Moment> moments;
    std::shared_ptr<const trace::Recording> recording;
};

/// Made once: a fresh run takes longer than many seeks.
const Subject& subject(std::size_t seed, std::size_t budget) {
    static std::array<std::array<Subject, budgets>, scenes> made;
    Subject& s = made[seed][budget];
    if (s.recording == nullptr) {
        const auto scene =
            seed % 2 == 0 ? tests::random_scene(1000 + seed) : tests::sampled_scene(1000 + seed);
        const auto pixels = static_cast<std::size_t>(scene->settings.width) *
                            static_cast<std::size_t>(scene->settings.height);
        s.moments = tests::fresh_run(scene);
        trace::RecordOptions options;
        options.checkpoint_budget = budget * pixels * 20; // none, none or one, one or two, …
        options.checkpoint_spacing = 1;
        auto recorded = trace::record(scene, options);
        HS_CHECK(recorded, "a small scene can be recorded");
        s.recording = *recorded;
        HS_CHECK(s.recording->end_step + 1 == s.moments.size(), "both count the same steps");
    }
    return s;
}

void move(trace::Player& player, fuzz::Bytes& bytes) {
    const auto kind = bytes.take<std::uint8_t>();
    const auto number = bytes.take<std::uint16_t>();
    const auto direction = kind % 2 == 0 ? Direction::forward : Direction::backward;
    switch (kind / 2 % 4) {
    case 0: player.seek(number % (player.end() + 2)); break;
    case 1:
        if (const auto found = player.find_stage(
                static_cast<trace::Stage>(number % trace::stage_count), direction
            )) {
            player.seek(*found);
        }
        break;
    default: player.advance(static_cast<Granularity>(number % 6), direction); break;
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr int most_moves = 64;
    fuzz::Bytes bytes(data, size);
    const auto seed = bytes.take<std::uint8_t>() % scenes;
    const auto budget = bytes.take<std::uint8_t>() % budgets;
    const Subject& s = subject(seed, budget);
    trace::Player player(s.recording);
    for (int i = 0; i < most_moves && !bytes.empty(); ++i) {
        move(player, bytes);
        const tests::Moment& moment = s.moments[player.step()];
        HS_CHECK(player.current().kind == moment.kind, "the same step");
        HS_CHECK(tests::shown_digest(player) == moment.framebuffer, "the same framebuffer");
        HS_CHECK(player.counters() == moment.counters, "the same counters");
    }
    return 0;
}
