#include "core/search/query.hpp"

#include "core/trace/history.hpp"
#include "tests/export/recorded.hpp"

#include <fmt/format.h>

using namespace hs;
using search::Query;

namespace {

std::vector<std::size_t> matches(const trace::Player& player, const std::string& expression) {
    Result<Query> query = Query::prepare(player, expression);
    if (!query) {
        FAIL(query.diagnostics().front().to_string());
    }
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < query->size(); ++row) {
        const Result<bool> matched = query->matches(row);
        REQUIRE(matched);
        if (*matched) {
            rows.push_back(row);
        }
    }
    return rows;
}

std::string complaint(const trace::Player& player, const std::string& expression) {
    const Result<Query> query = Query::prepare(player, expression);
    return query ? "no complaint" : query.diagnostics().front().to_string();
}

} // namespace

TEST_CASE("matching fragments are those a linear scan of the log finds", "[property][search]") {
    for (std::uint64_t seed = 0; seed < tests::random_frames; ++seed) {
        INFO(seed);
        const trace::Player player = tests::random_player(seed);
        const trace::Recording& recording = player.recording();
        std::vector<std::size_t> failed;
        std::vector<std::size_t> of_first;
        for (std::uint32_t i = 0; i < player.fragments_done(); ++i) {
            const trace::FragmentRecord& fragment = recording.fragments[i];
            if (fragment.fate == fragment::FragmentFate::depth_failed && fragment.depth > 0.25F) {
                failed.push_back(i);
            }
            const std::uint32_t triangle = recording.run_of_fragment(i).triangle;
            if (recording.object_of_triangle(triangle) == 0 && fragment.x >= fragment.y) {
                of_first.push_back(i);
            }
        }
        CHECK(
            matches(player, "fragment.fate == 'depth failed' and fragment.depth > 0.25") == failed
        );
        CHECK(
            matches(
                player, "fragment.pixel.x >= fragment.pixel.y and triangle.object_index == 0"
            ) == of_first
        );
    }
}

TEST_CASE("the fragments of a pixel are its history, and end where it says", "[property][search]") {
    for (std::uint64_t seed = 0; seed < tests::random_frames; ++seed) {
        INFO(seed);
        trace::Player player = tests::random_player(seed);
        player.seek(player.end());
        const trace::Recording& recording = player.recording();
        const PixelPos pixel{recording.width() / 2, recording.height() / 2};
        std::vector<std::size_t> expected;
        for (const trace::HistoryRow& row : trace::pixel_history(recording, pixel).rows) {
            expected.push_back(row.fragment);
        }
        const std::string expression =
            fmt::format("fragment.pixel.x == {} and fragment.pixel.y == {}", pixel.x, pixel.y);
        CHECK(matches(player, expression) == expected);
        const Result<Query> query = Query::prepare(player, expression);
        REQUIRE(query);
        for (const std::size_t row : expected) {
            const trace::Step step = trace::describe_step(recording, query->step_of(row));
            CHECK(step.fragment == row);
            CHECK(step.pixel == pixel);
        }
    }
}

TEST_CASE("steps, triangles and vertices are searched by what they are", "[property][search]") {
    for (std::uint64_t seed = 0; seed < tests::random_frames; ++seed) {
        INFO(seed);
        trace::Player player = tests::random_player(seed);
        const trace::Recording& recording = player.recording();
        std::vector<std::size_t> failed_tests;
        for (trace::StepId i = 0; i <= player.step(); ++i) {
            const trace::Step step = trace::describe_step(recording, i);
            if (step.kind == trace::StepKind::depth_test && !step.passed) {
                failed_tests.push_back(i);
            }
        }
        CHECK(matches(player, "step.kind == 'depth test' and step.passed == 0") == failed_tests);

        std::vector<std::size_t> behind;
        for (std::size_t i = 0; i < recording.triangles.size(); ++i) {
            const auto number = static_cast<std::uint32_t>(i);
            const std::uint32_t object = recording.object_of_triangle(number);
            const pipeline::DrawCall& call = recording.frame->calls()[object];
            const scene::TriangleIndices& corners =
                call.triangles()[number - recording.objects[object].first_triangle];
            if (call.vertices[corners.b].clip.w <= 0.5F) {
                behind.push_back(i);
            }
        }
        CHECK(matches(player, "b.clip.w <= 0.5") == behind);

        const Result<Query> vertices = Query::prepare(player, "vertex.clip.w < 1e9");
        REQUIRE(vertices);
        CHECK(vertices->columns() == std::vector<std::string>{"vertex.clip.w"});
        for (std::size_t row = 0; row < vertices->size(); row += 7) {
            const trace::Step step = trace::describe_step(recording, vertices->step_of(row));
            CHECK(step.in_vertex_stage());
            CHECK(recording.objects[step.object].first_vertex + step.vertex == row);
        }
    }
}

TEST_CASE("what never meets in a row is refused in a sentence", "[unit][search]") {
    const trace::Player player = tests::random_player(1);
    CHECK(
        complaint(player, "1 < 2") ==
        "expression: names nothing to search; begin with vertex, triangle, fragment or step, for "
        "example fragment.depth < 0.5"
    );
    CHECK(
        complaint(player, "vertex.clip.w < triangle.face") ==
        "expression: vertex stands for every vertex of the frame; a triangle's corners are called "
        "a, b and c"
    );
    CHECK(
        complaint(player, "step.pixel.x == fragment.pixel.x").find("cannot be joined") !=
        std::string::npos
    );
    CHECK(
        complaint(player, "fragment.fate == 'depth fail'").find("\"depth failed\"") !=
        std::string::npos
    );
}

TEST_CASE("every known name can be asked", "[unit][search]") {
    const trace::Player player = tests::random_player(2);
    for (const search::KnownName& name : search::known_names(player)) {
        std::string path = name.path;
        if (path.ends_with(".0") || path.ends_with(".1") || path.ends_with(".2")) {
            path = path.substr(0, path.size() - 2) + '[' + path.back() + ']';
        }
        INFO(path);
        const Result<Query> query = Query::prepare(player, path + " == " + path);
        CHECK(query);
    }
}
