#include "core/trace/trail.hpp"

#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/made_scene.hpp"

#include <algorithm>

using namespace hs;
using trace::StepKind;

namespace {

std::shared_ptr<const trace::Recording> recorded(scene::TraversalKind kind) {
    auto scene = tests::clip_space_scene(
        {{-0.9F, -0.7F, 0.0F, 1.0F}, {0.8F, -0.9F, 0.0F, 1.0F}, {0.3F, 0.95F, 0.0F, 1.0F}}, 16, 16
    );
    scene->settings.traversal = kind;
    scene->settings.tile_size = 8;
    return trace::record(scene).value();
}

/// What a trail must hold, gathered from the steps themselves.
struct Gathered {
    std::vector<PixelPos> visits;
    std::size_t tiles = 0;
    std::size_t spans = 0;

    void add(const trace::Step& step) {
        const bool asked = step.kind == StepKind::edge_test || step.kind == StepKind::plane_test;
        const bool known =
            step.kind == StepKind::interpolate && (visits.empty() || visits.back() != step.pixel);
        if (asked || known) {
            visits.push_back(step.pixel);
        }
        tiles += step.kind == StepKind::tile_test ? 1U : 0U;
        spans += step.kind == StepKind::span ? 1U : 0U;
    }
};

} // namespace

TEST_CASE("a trail holds what the steps before it told, under every traversal", "[trace]") {
    for (const auto& [kind, name, explanation] : names<scene::TraversalKind>()) {
        const auto recording = recorded(kind);
        INFO(name);
        trace::Player player(recording);
        Gathered gathered;
        int wrong = 0;
        for (trace::StepId id = recording->first_triangle_step; id < recording->end_step; ++id) {
            player.seek(id);
            gathered.add(player.current());
            const trace::Trail trail = trace::trail(*recording, player.current());
            if (!player.current().in_unit()) {
                CHECK(trail.visits.empty());
                continue;
            }
            const bool same =
                std::ranges::equal(trail.visits, gathered.visits, {}, &trace::TrailVisit::pixel);
            wrong +=
                same && trail.tiles.size() == gathered.tiles && trail.spans.size() == gathered.spans
                    ? 0
                    : 1;
        }
        CHECK(wrong == 0);
        CHECK(gathered.visits.size() >= recording->fragments.size());
    }
}

TEST_CASE("the trail of a large piece begins with the step's unit", "[trace]") {
    const auto recording = recorded(scene::TraversalKind::bounding_box);
    trace::Player player(recording);
    const auto step = trace::find_step(*recording, "object 0 / triangle 0 / pixel 8,9").value();
    player.seek(step);
    const trace::Trail trail = trace::trail(*recording, player.current(), 20);
    CHECK_FALSE(trail.whole);
    REQUIRE_FALSE(trail.visits.empty());
    CHECK(trail.visits.front().pixel.y == 9);
    CHECK(trail.visits.back().pixel == PixelPos{8, 9});
    CHECK(trace::trail(*recording, player.current()).whole);
}
