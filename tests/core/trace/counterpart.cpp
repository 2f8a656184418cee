#include "core/trace/counterpart.hpp"

#include "core/scene/scene_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/made_scene.hpp"
#include "tests/support/paths.hpp"

using namespace hs;
using trace::Match;
using trace::StepId;

namespace {

std::shared_ptr<const trace::Recording>
recorded(const std::string& file, const std::vector<scene::Assignment>& changes = {}) {
    const auto path = test::source_dir() / "lessons" / "scenes" / file;
    Result<scene::Scene> scene = scene::load_scene(path, changes);
    REQUIRE(scene);
    return trace::record(std::make_shared<const scene::Scene>(std::move(*scene))).value();
}

std::shared_ptr<const trace::Recording> sliver(scene::TraversalKind traversal) {
    return recorded("sliver.toml", {{"traversal", std::string{name_of(traversal)}}});
}

std::string path(const trace::Recording& recording, StepId step) {
    return trace::step_path(trace::describe_step(recording, step));
}

/// Where `other` stands when one stands on a written path.
trace::Counterpart
from(const trace::Recording& one, std::string_view written, const trace::Recording& other) {
    const StepId step = trace::find_step(one, written).value();
    return trace::counterpart(other, trace::describe_step(one, step));
}

} // namespace

TEST_CASE("every step of a recording is its own counterpart", "[trace][beside]") {
    const auto recording = sliver(scene::TraversalKind::hierarchical);
    for (StepId step = 0; step <= recording->end_step; ++step) {
        const auto there = trace::counterpart(*recording, trace::describe_step(*recording, step));
        CHECK(there == trace::Counterpart{step, Match::same_step});
    }
}

TEST_CASE(
    "under every pair of traversals, what happens to a fragment has the same step in both",
    "[trace][beside]"
) {
    for (const auto& one : names<scene::TraversalKind>()) {
        const auto a = sliver(one.value);
        for (const auto& two : names<scene::TraversalKind>()) {
            const auto b = sliver(two.value);
            INFO(one.name << " beside " << two.name);
            int fragments = 0;
            for (StepId id = 0; id <= a->end_step; id += 3) {
                const trace::Step step = trace::describe_step(*a, id);
                const trace::Counterpart there = trace::counterpart(*b, step);
                const trace::Step other = trace::describe_step(*b, there.step);
                CHECK(other.in_triangle() == step.in_triangle());
                if (step.in_fragment()) {
                    ++fragments;
                    CHECK(there.match == Match::same_step);
                    CHECK(other.kind == step.kind);
                    CHECK(other.pixel == step.pixel);
                }
                if (there.match == Match::same_pixel && !step.of_scanline()) {
                    CHECK(other.pixel == step.pixel);
                }
                if (there.match == Match::same_scanline) {
                    CHECK(other.pixel.y == step.pixel.y);
                }
            }
            CHECK(fragments > 30);
        }
    }
}

TEST_CASE(
    "what the other does not ask is answered on the nearest thing both have", "[trace][beside]"
) {
    const auto every = sliver(scene::TraversalKind::brute_force);
    const auto box = sliver(scene::TraversalKind::bounding_box);
    const auto walk = sliver(scene::TraversalKind::edge_walk);

    // Left of the box: the box is done with the row
    const auto left = from(*every, "triangle 0 / pixel 0,10", *box);
    CHECK(left.match == Match::same_scanline);
    CHECK(trace::describe_step(*box, left.step).pixel.y == 10);
    // Above the box: it is done with the triangle
    const auto above = from(*every, "triangle 0 / pixel 0,0", *box);
    CHECK(above == trace::Counterpart{box->end_step - 1, Match::same_part});
    // Edges that are walked find pixels without asking them
    const auto covered = from(*every, "triangle 0 / pixel 15,10", *walk);
    CHECK(covered.match == Match::same_pixel);
    CHECK(path(*walk, covered.step) == "object 0 / triangle 0 / fragment 15,10 / interpolate");
    const auto span = from(*walk, "triangle 0 / scanline 10 / span", *box);
    CHECK(span.match != Match::same_step);
    CHECK(trace::describe_step(*box, span.step).pixel.y == 10);
}

TEST_CASE("without clipping, steps of clipping stand on the outcodes", "[trace][beside]") {
    constexpr std::string_view behind = R"(
[camera]
eye = [0, 0, 3]
[[object]]
vertices = [[-1, -0.6, 0], [1, -0.6, 0], [0.5, 1, 4.5]]
polygons = [[0, 1, 2]]
)";
    const auto with = [&](const char* truth) {
        const std::vector<scene::Assignment> changes{{"clip.enabled", truth}};
        const auto scene = scene::parse_scene(behind, "behind.toml", changes);
        return trace::record(std::make_shared<const scene::Scene>(*scene)).value();
    };
    const auto clipped = with("true");
    const auto wrapped = with("false");
    const auto cut = from(*clipped, "triangle 0 / clip / plane near", *wrapped);
    CHECK(cut.match == Match::same_part);
    CHECK(trace::describe_step(*wrapped, cut.step).kind == trace::StepKind::outcodes);
    const auto second = from(*clipped, "triangle 0 piece 1 / divide", *wrapped);
    CHECK(path(*wrapped, second.step) == "object 0 / triangle 0 / divide");
    CHECK(trace::difference(*clipped, *wrapped).color.size() > 100);
}

TEST_CASE("by count, the shorter run waits at its end", "[trace][beside]") {
    const auto every = sliver(scene::TraversalKind::brute_force);
    const auto tiles = sliver(scene::TraversalKind::hierarchical);
    const StepId first = every->triangles[0].first_step;
    REQUIRE(every->end_step > tiles->end_step);
    for (StepId id = first; id < every->end_step; ++id) {
        const trace::Step step = trace::describe_step(*every, id);
        const auto there = trace::counterpart_by_count(*tiles, *every, step);
        const StepId same = tiles->triangles[0].first_step + (id - first);
        CHECK(there.step == std::min(same, tiles->end_step - 1));
    }
}

TEST_CASE("two pictures differ exactly where a test was switched off", "[trace][beside]") {
    // Four by four pixels drawn twice; without writing depth the second layer is the same color
    const auto scene = tests::stacked_scene(2, 4, 4);
    const auto one = trace::record(scene).value();
    CHECK(trace::difference(*one, *one).color.empty());
    CHECK(trace::difference(*one, *one).depths == 0);

    const auto no_depth = std::make_shared<scene::Scene>(*scene);
    no_depth->settings.depth_write = false;
    const auto unwritten = trace::record(no_depth).value();
    CHECK(trace::difference(*one, *unwritten).color.empty());
    CHECK(trace::difference(*one, *unwritten).depths == 16);

    const auto cut = std::make_shared<scene::Scene>(*scene);
    cut->settings.scissor = PixelRect{1, 2, 4, 4};
    const auto partial = trace::record(cut).value();
    const trace::Difference apart = trace::difference(*one, *partial);
    REQUIRE(apart.color.size() == 16 - 6);
    CHECK(apart.color.front() == PixelPos{0, 0});
    CHECK(apart.color.back() == PixelPos{0, 3});
}
