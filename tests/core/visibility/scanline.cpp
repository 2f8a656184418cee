#include "core/visibility/scanline.hpp"

#include "core/visibility/scanline_z.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/visible_surfaces.hpp"

#include <algorithm>
#include <map>
#include <string>

using namespace hs;
using tests::window_triangle;
using visibility::ScanSpan;
using visibility::ScanState;
using visibility::SweepEvent;
using visibility::SweepEventKind;
using visibility::WindowPolygon;

namespace {

/// The lecture's two triangles. Its scanlines are whole numbers; ours run through pixel centers.
std::vector<WindowPolygon> two_triangles() {
    const auto at = [](double x, double y, double z) { return glm::dvec3{x + 0.5, y + 0.5, z}; };
    return {
        window_triangle(0, at(5, 1, 0.5), at(11, 9, 0.5), at(2, 16, 0.5)),
        window_triangle(1, at(13, 4, 0.3), at(15, 15, 0.3), at(6, 9, 0.3))};
}

/// "AC" for the edge from A to C.
std::string name(const visibility::ScanEdge& edge) {
    const auto letter = [&](std::int32_t corner) {
        return static_cast<char>('A' + 3 * edge.polygon + corner);
    };
    return {letter(edge.from), letter(edge.to)};
}

struct RowTrace {
    std::map<int, std::string> active; ///< per row, "AC AB …"
    std::vector<SweepEvent> events;
    void sweep_step(const SweepEvent& event, const ScanState& state) {
        events.push_back(event);
        if (event.kind != SweepEventKind::active_edges) {
            return;
        }
        for (const visibility::ActiveScanEdge& edge : state.active) {
            std::string& names = active[state.row];
            names += (names.empty() ? "" : " ") + name(state.scene->table.edge(edge.edge));
        }
    }
    [[nodiscard]] std::vector<SweepEvent> of(SweepEventKind kind) const {
        std::vector<SweepEvent> result;
        for (const SweepEvent& event : events) {
            if (event.kind == kind) {
                result.push_back(event);
            }
        }
        return result;
    }
};

struct LineTests {
    int tests = 0;
    template <typename State>
    void sweep_step(const SweepEvent& event, const State&) {
        tests += event.kind == SweepEventKind::depth ? 1 : 0;
    }
};

/// What the spans show at each pixel center.
std::vector<std::int32_t>
pixels_of(const std::vector<WindowPolygon>& polygons, int width, int height) {
    std::vector<std::int32_t> pixels(
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -2
    );
    visibility::SilentSweep silent;
    visibility::scan_visible(polygons, width, height, silent, [&](const ScanSpan& span) {
        const int end = visibility::first_pixel(span.x_end);
        for (int x = visibility::first_pixel(span.x); x < end; ++x) {
            pixels[static_cast<std::size_t>(span.row * width + x)] = span.polygon;
        }
    });
    return pixels;
}

std::vector<std::int32_t>
line_pixels_of(const std::vector<WindowPolygon>& polygons, int width, int height) {
    std::vector<std::int32_t> pixels;
    visibility::SilentSweep silent;
    visibility::scan_with_line_buffer(
        polygons,
        width,
        height,
        silent,
        [&](const visibility::LineBuffer& line) {
            pixels.insert(pixels.end(), line.polygon.begin(), line.polygon.end());
        }
    );
    return pixels;
}

} // namespace

TEST_CASE("the two triangles have the lecture's five lists of active edges", "[visibility]") {
    RowTrace trace;
    visibility::scan_visible(two_triangles(), 20, 20, trace, [](const ScanSpan&) {});
    const auto check = [&](int first, int last, const std::string& names) {
        for (int row = first; row <= last; ++row) {
            INFO("row " << row);
            CHECK(trace.active[row] == names);
        }
    };
    CHECK_FALSE(trace.active.contains(0));
    check(1, 3, "AC AB");
    check(4, 6, "AC AB DF DE");
    check(7, 8, "AC DF AB DE");
    check(9, 10, "AC FE BC DE");
    check(11, 14, "AC BC FE DE");
    check(15, 15, "AC BC");
    CHECK_FALSE(trace.active.contains(16));
}

TEST_CASE("what is visible is decided on entering and on leaving", "[visibility]") {
    // The far one is entered first and left last: in between the near one comes and goes
    RowTrace trace;
    std::vector<ScanSpan> spans;
    visibility::scan_visible(
        {tests::window_rectangle(0, {2, 0}, {18, 1}, 0.8),
         tests::window_rectangle(1, {6, 0}, {10, 1}, 0.2)},
        20,
        1,
        trace,
        [&](const ScanSpan& span) { spans.push_back(span); }
    );
    REQUIRE(spans.size() == 5);
    const std::vector<std::int32_t> expected{-1, 0, 1, 0, -1};
    for (std::size_t i = 0; i < spans.size(); ++i) {
        CHECK(spans[i].polygon == expected[i]);
        CHECK(spans[i].x == (i == 0 ? 0.0 : spans[i - 1].x_end)); // no gap
    }
    CHECK(spans.back().x_end == 20.0);
    CHECK(trace.of(SweepEventKind::cross).size() == 4);
    CHECK(trace.of(SweepEventKind::compare).size() == 1); // only where two are inside
    CHECK(trace.of(SweepEventKind::false_edge).empty());
}

TEST_CASE("a polygon that comes through another makes a false edge", "[visibility]") {
    RowTrace trace;
    std::vector<ScanSpan> spans;
    const auto ramp = [](std::uint32_t number, double left, double right) {
        return window_triangle(number, {0, -1, left}, {16, -1, right}, {0, 99, left});
    };
    visibility::scan_visible(
        {ramp(0, 0.2, 0.8), ramp(1, 0.6, 0.4)},
        15,
        1,
        trace,
        [&](const ScanSpan& span) { spans.push_back(span); }
    );
    const auto edges = trace.of(SweepEventKind::false_edge);
    REQUIRE(edges.size() == 1);
    CHECK(edges[0].x == Approx(8.0)); // 0.2 + 0.6 u = 0.6 - 0.2 u at u = 1/2
    CHECK(edges[0].polygon == 1);
    CHECK(edges[0].other == 0);
    REQUIRE(spans.size() >= 2);
    CHECK(spans[0].polygon == 0);
    CHECK(spans[1].polygon == 1);
}

TEST_CASE("scanlines show the nearest triangle at every pixel center", "[property][visibility]") {
    tests::Random random(441);
    int asked = 0;
    int wrong = 0;
    for (int round = 0; round < 60; ++round) {
        const auto given =
            tests::random_window_triangles(2 + random.below(30), random.between(5, 60), random);
        const auto spans = pixels_of(given, 100, 100);
        const auto lines = line_pixels_of(given, 100, 100);
        for (std::size_t i = 0; i < spans.size(); ++i) {
            const std::size_t row = i / 100;
            const glm::dvec2 point{
                static_cast<double>(i % 100) + 0.5, static_cast<double>(row) + 0.5};
            const auto nearest = tests::nearest_at(given, point, 1.0e-9, 1.0e-9);
            if (nearest) {
                ++asked;
                wrong += spans[i] == *nearest && lines[i] == *nearest ? 0 : 1;
            }
        }
    }
    CHECK(wrong == 0);
    CHECK(asked > 590'000);
}

TEST_CASE("every pixel center on a shared edge belongs to exactly one triangle", "[visibility]") {
    // The diagonal runs through pixel centers
    const std::vector<WindowPolygon> square{
        window_triangle(0, {0, 0, 0.5}, {8, 0, 0.5}, {8, 8, 0.5}),
        window_triangle(1, {0, 0, 0.5}, {8, 8, 0.5}, {0, 8, 0.5})};
    LineTests count;
    visibility::scan_with_line_buffer(square, 8, 8, count, [](const visibility::LineBuffer&) {});
    CHECK(count.tests == 64);
    CHECK(std::ranges::count(pixels_of(square, 8, 8), -1) == 0);
}

TEST_CASE(
    "pictures without polygons, and polygons without pixels, show the background", "[visibility]"
) {
    const auto background = std::vector<std::int32_t>(16, -1);
    CHECK(pixels_of({}, 4, 4) == background);
    const std::vector<WindowPolygon> unseen{
        window_triangle(0, {-9, -9, 0.5}, {-1, -9, 0.5}, {-9, -1, 0.5}),        // beside the image
        window_triangle(1, {0, 1, 0.5}, {2, 1, 0.5}, {4, 1, 0.5}),              // a horizontal line
        window_triangle(2, {1, 0, 0.1}, {1, 4, 0.5}, {1, 4, 0.9}),              // edge-on
        window_triangle(3, {1e300, 0, 0.5}, {1e300, 4, 0.5}, {2e300, 4, 0.5})}; // far away
    CHECK(pixels_of(unseen, 4, 4) == background);
    CHECK(line_pixels_of(unseen, 4, 4) == background);
}
