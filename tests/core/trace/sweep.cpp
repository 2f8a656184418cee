// Scanlines and rays as steps: paths, states, sentences, and the lecture's worked example.
#include "core/explain/sweep.hpp"

#include "core/explain/sentence.hpp"
#include "core/scene/scene_file.hpp"
#include "core/trace/player.hpp"
#include "core/trace/sweep_detail.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <fmt/format.h>

using namespace hs;
using scene::Visibility;
using visibility::SweepEventKind;

namespace {

trace::Player shown_by(Visibility visibility, const char* name = "scanline-triangles.toml") {
    auto scene = scene::load_scene(test::source_dir() / "lessons/scenes" / name);
    REQUIRE(scene);
    scene->settings.visibility = visibility;
    auto recording = trace::record(std::make_shared<scene::Scene>(*scene));
    REQUIRE(recording);
    return trace::Player(*recording);
}

trace::StepId found(const trace::Player& player, const std::string& path) {
    const auto step = trace::find_step(player.recording(), path);
    INFO(path);
    REQUIRE(step);
    return *step;
}

std::string sentence_at(trace::Player& player, const std::string& path) {
    player.seek(found(player, path));
    return explain::sentence(player);
}

/// "AC AB", once the scanline's edges are up to date.
std::string active_edges(trace::Player& player, int row) {
    player.seek(found(player, fmt::format("scanline {} / active edges", row)));
    const auto detail = trace::sweep_detail(player.recording(), player.current());
    std::string names;
    for (const visibility::ActiveScanEdge& edge : detail.scan->active) {
        names += names.empty() ? "" : " ";
        names += explain::edge_label(player.recording(), *detail.scan->scene, edge.edge);
    }
    return names;
}

} // namespace

TEST_CASE("the shipped scene has the lecture's five lists of active edges", "[trace]") {
    for (const Visibility visibility : {Visibility::scanline, Visibility::scanline_z}) {
        trace::Player player = shown_by(visibility);
        const auto check = [&](int first, int last, const std::string& names) {
            for (int row = first; row <= last; ++row) {
                INFO("scanline " << row);
                CHECK(active_edges(player, row) == names);
            }
        };
        check(0, 0, "");
        check(1, 3, "AC AB");
        check(4, 6, "AC AB DF DE");
        check(7, 8, "AC DF AB DE");
        check(9, 10, "AC FE BC DE");
        check(11, 14, "AC BC FE DE");
        check(15, 15, "AC BC");
        check(16, 19, "");
    }
}

TEST_CASE("every step of a frame of scanlines or rays is found by its path", "[trace]") {
    for (const Visibility visibility :
         {Visibility::scanline, Visibility::scanline_z, Visibility::ray_cast}) {
        for (const char* const scene : {"scanline-triangles.toml", "crossing-triangles.toml"}) {
            trace::Player player = shown_by(visibility, scene);
            const trace::Recording& recording = player.recording();
            const trace::StepId stride = recording.end_step / 1500 + 1;
            for (trace::StepId id = recording.first_sweep_step; id < recording.end_step;
                 id += stride) {
                const std::string path = trace::step_path(trace::describe_step(recording, id));
                INFO(path);
                REQUIRE(found(player, path) == id);
            }
        }
    }
}

TEST_CASE("paths of scanlines and rays nest as their loops do", "[trace]") {
    trace::Player scanline = shown_by(Visibility::scanline);
    const trace::Recording& recording = scanline.recording();
    const auto path_of = [&](const std::string& path) {
        return trace::step_path(trace::describe_step(recording, found(scanline, path)));
    };
    CHECK(path_of("scanline 7 / edge 3") == "scanline 7 / edge 3");
    CHECK(path_of("edge 3 / scanline 7") == "scanline 7 / edge 3");
    // After its last child: the background at the right
    CHECK(path_of("scanline 7") == "scanline 7 / span 4");
    CHECK(path_of("object 1 / fragment 10,7") == "object 1 / triangle 0 / fragment 10,7 / merge");
    CHECK(found(scanline, "visibility") + 1 == recording.end_step);

    trace::Player ray = shown_by(Visibility::ray_cast);
    const trace::StepId meeting = found(ray, "pixel 10,7 / object 1 / meeting");
    const trace::Step step = trace::describe_step(ray.recording(), meeting);
    CHECK(trace::step_path(step) == "pixel 10,7 / object 1 / triangle 0 / meeting");
    CHECK(step.sweep == SweepEventKind::meet);
}

TEST_CASE("a path that no scanline has is one sentence", "[trace]") {
    const trace::Player player = shown_by(Visibility::scanline);
    const auto complaint = [&](const char* path) {
        const auto step = trace::find_step(player.recording(), path);
        REQUIRE_FALSE(step);
        return step.diagnostics().front().message;
    };
    CHECK(complaint("scanline 20") == "there is no scanline 20; those drawn are 0 to 19");
    CHECK(complaint("scanline 7 / edge 4").starts_with("scanline 7 has no such step"));
    CHECK(complaint("edge 3").starts_with("say which scanline or pixel"));
    CHECK(complaint("scanline 7 / ray").starts_with("scanline 7 has no such step"));
    const trace::Player other = shown_by(Visibility::z_buffer);
    const auto step = trace::find_step(other.recording(), "scanline 7 / edge 3");
    REQUIRE_FALSE(step);
    CHECK(step.diagnostics().front().message.starts_with("say which scanline or pixel"));
}

TEST_CASE("decisions of a scanline are told with their numbers", "[explain]") {
    trace::Player player = shown_by(Visibility::scanline);
    CHECK(
        sentence_at(player, "scanline 4 / edge in 0") ==
        "Edge DE of \"DEF\" begins: it crosses scanline 4 at x = 13.5000 and joins the active "
        "edges."
    );
    CHECK(
        sentence_at(player, "scanline 7 / active edges") ==
        "Scanline 7 crosses 4 active edges, from left to right: AC, DF, AB, DE."
    );
    CHECK(
        sentence_at(player, "scanline 7 / comparison 0") ==
        "At x = 9.3000 depth 0.3000 of \"DEF\" is nearer than 0.5000 of \"ABC\"."
    );
    CHECK(sentence_at(player, "scanline 0 / active edges") == "No edge crosses scanline 0.");
    CHECK(
        sentence_at(player, "scanline 0 / span 0") ==
        "From x = 0.0000 to 20.0000 the background is visible: pixels 0 to 19."
    );
}

TEST_CASE("every decision of scanlines and rays is told in one sentence", "[explain]") {
    for (const Visibility visibility :
         {Visibility::scanline, Visibility::scanline_z, Visibility::ray_cast}) {
        trace::Player player = shown_by(visibility, "crossing-triangles.toml");
        trace::SweepCounts told{};
        const trace::Recording& recording = player.recording();
        const trace::StepId stride = recording.end_step / 3000 + 1;
        for (trace::StepId id = recording.first_sweep_step; id < recording.end_step; id += stride) {
            player.seek(id);
            const std::string text = explain::sentence(player);
            INFO(text);
            REQUIRE(text.ends_with('.'));
            REQUIRE(((text.front() >= 'A' && text.front() <= 'Z') || text.front() == '"'));
            if (player.current().kind == trace::StepKind::sweep) {
                ++told[static_cast<std::size_t>(player.current().sweep)];
                const auto detail = trace::sweep_detail(recording, player.current());
                REQUIRE(detail.last().kind == player.current().sweep);
                static_cast<void>(explain::sweep_formulas(recording, detail));
            }
        }
        for (std::size_t kind = 0; kind < told.size(); ++kind) {
            INFO(names<SweepEventKind>()[kind].name);
            CHECK((told[kind] > 0) == (recording.counters.sweeps[kind] > 0));
        }
    }
}

TEST_CASE("stepping by row and by pixel stops where rows and rays end", "[trace]") {
    trace::Player player = shown_by(Visibility::ray_cast);
    const trace::Recording& recording = player.recording();
    player.seek(recording.first_sweep_step - 1);
    for (int i = 0; i < recording.width(); ++i) {
        player.advance(trace::Granularity::fragment, trace::Direction::forward);
        CHECK(player.current().pixel == PixelPos{i, 0});
    }
    for (int row = 1; row < recording.height(); ++row) {
        player.advance(trace::Granularity::scanline, trace::Direction::forward);
        CHECK(player.current().pixel == PixelPos{recording.width() - 1, row});
    }
    CHECK(player.step() + 1 == recording.end_step);
    player.seek(0);
    player.advance(trace::Granularity::stage, trace::Direction::forward);
    CHECK(player.step() + 1 == recording.first_order_step);
    player.advance(trace::Granularity::stage, trace::Direction::forward);
    CHECK(player.step() + 1 == recording.first_sweep_step);
    player.advance(trace::Granularity::stage, trace::Direction::forward);
    CHECK(player.step() + 1 == recording.end_step);
}

TEST_CASE("rays ask every triangle at every pixel, and keep the nearest", "[trace]") {
    const trace::Player player = shown_by(Visibility::ray_cast);
    const trace::SweepCounts& counts = player.recording().counters.sweeps;
    CHECK(counts[static_cast<std::size_t>(SweepEventKind::cast)] == 400);
    CHECK(counts[static_cast<std::size_t>(SweepEventKind::meet)] == 800);
    // Behind DEF, ABC is hit too
    CHECK(
        counts[static_cast<std::size_t>(SweepEventKind::keep)] > player.recording().fragments.size()
    );
}

TEST_CASE("triangles that no row shows are unseen", "[trace]") {
    trace::Player player = shown_by(Visibility::scanline, "six-polygons.toml");
    int shown = 0;
    for (const trace::TriangleRecord& triangle : player.recording().triangles) {
        const bool drawn = triangle.verdict == geometry::TriangleVerdict::drawn;
        CHECK((drawn || triangle.verdict == geometry::TriangleVerdict::unseen));
        shown += drawn ? 1 : 0;
    }
    CHECK(shown >= 10);
}
