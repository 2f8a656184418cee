// Lines and points, decided by us and by Mesa's llvmpipe. docs/lines-and-points.md has the rules in
// words; each test holds one of its sentences, and counts that what it allows does occur.
#include "core/raster/line_bresenham.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesa.hpp"
#include "tests/support/rasterized.hpp"
#include "tests/support/triangle_soup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <vector>

using namespace hs;

namespace {

constexpr PixelRect image{0, 0, 64, 64};
using Pixels = std::set<std::pair<int, int>>;

struct Ends {
    glm::dvec2 from;
    glm::dvec2 to;
};

/// What Mesa covers, one set per primitive of 24.
std::vector<Pixels>
theirs(peer::Context& mesa, const std::vector<glm::vec4>& corners, peer::Primitive primitive) {
    const peer::Coverage coverage = mesa.coverage(
        corners, {.primitive = primitive, .width = image.width(), .height = image.height()}
    );
    REQUIRE(coverage.error.empty());
    std::vector<Pixels> sets(corners.size() / static_cast<std::size_t>(primitive));
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const auto word = static_cast<std::size_t>(y * image.width() + x);
            for (std::size_t k = 0; k < sets.size(); ++k) {
                if ((coverage.bits[word] >> k & 1U) != 0) {
                    sets[k].emplace(x, y);
                }
            }
        }
    }
    return sets;
}

FixedPosition snapped(const glm::vec4& clip) {
    const auto viewport = geometry::make_viewport(image, scene::DepthConvention::opengl);
    return geometry::to_window({clip.x, clip.y, clip.z, clip.w}, viewport).fixed;
}

struct OurLine {
    raster::LineSetup setup;
    Pixels pixels;
};

OurLine ours(const glm::vec4& from, const glm::vec4& to) {
    OurLine line{raster::set_up_line(snapped(from), snapped(to)), {}};
    raster::SilentTraversal silent;
    raster::walk_bresenham(line.setup, image, silent, [&line](PixelPos pixel) {
        line.pixels.emplace(pixel.x, pixel.y);
    });
    return line;
}

/// Calls `check(Mesa's pixels, our line)` for so many lines with ends that `end` makes.
template <typename MakeEnd, typename Check>
void for_lines(int batches, MakeEnd&& end, Check&& check) {
    peer::Context* mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    tests::Random random(4711);
    for (int i = 0; i < batches; ++i) {
        std::vector<glm::vec4> corners;
        for (std::size_t k = 0; k < 2 * peer::coverage_batch_size; ++k) {
            corners.push_back(tests::clip_at(end(random), 0.0F, 1.0F, image));
        }
        const std::vector<Pixels> sets = theirs(*mesa, corners, peer::Primitive::lines);
        for (std::size_t k = 0; k < sets.size(); ++k) {
            check(sets[k], ours(corners[2 * k], corners[2 * k + 1]));
        }
    }
}

glm::dvec2 center(tests::Random& random) {
    return {1.5 + random.below(60), 1.5 + random.below(60)};
}

glm::dvec2 anywhere(tests::Random& random) {
    return {
        static_cast<double>(random.between(1.0F, 62.0F)),
        static_cast<double>(random.between(1.0F, 62.0F))};
}

/// Whether the ideal line runs exactly through the middle between two pixels at a pixel's step.
bool is_tie(const raster::LineSetup& line, int x, int y) {
    const int k = std::abs(line.steep ? y - line.first.y : x - line.first.x);
    return line.steps > 0 && (2 * std::int64_t{line.rise} * k) % (2 * std::int64_t{line.steps}) ==
                                 std::int64_t{line.steps};
}

std::pair<int, int> pair_of(PixelPos pixel) {
    return {pixel.x, pixel.y};
}

/// Along and across a line, from its first pixel.
std::pair<int, int> along_and_across(const raster::LineSetup& line, int x, int y) {
    const int dx = x - line.first.x;
    const int dy = y - line.first.y;
    return line.steep ? std::pair{dy, dx} : std::pair{dx, dy};
}

} // namespace

TEST_CASE(
    "points are the same pixels; between two of them Mesa takes the left or upper one",
    "[oracle][line]"
) {
    peer::Context* mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    tests::Random random(1);
    int ties = 0;
    for (int i = 0; i < 1000; ++i) {
        std::vector<glm::vec4> corners;
        for (std::size_t k = 0; k < peer::coverage_batch_size; ++k) {
            const glm::dvec2 on_lattice{
                1.0 + random.below(120) * 0.5, 1.0 + random.below(120) * 0.5};
            const glm::dvec2 at = random.one_in(2) ? anywhere(random) : on_lattice;
            corners.push_back(tests::clip_at(at, 0.0F, 1.0F, image));
        }
        const std::vector<Pixels> sets = theirs(*mesa, corners, peer::Primitive::points);
        for (std::size_t k = 0; k < sets.size(); ++k) {
            const FixedPosition f = snapped(corners[k]);
            const PixelPos pixel = raster::pixel_of(f);
            const bool tie_x = f.x == pixel.x * subpixel_scale - subpixel_scale / 2;
            const bool tie_y = f.y == pixel.y * subpixel_scale - subpixel_scale / 2;
            ties += tie_x || tie_y ? 1 : 0;
            INFO("at " << f.x << " / 256, " << f.y << " / 256");
            REQUIRE(sets[k] == Pixels{{pixel.x - (tie_x ? 1 : 0), pixel.y - (tie_y ? 1 : 0)}});
        }
    }
    CHECK(ties > 1000);
}

TEST_CASE(
    "between pixel centers, Mesa takes the same pixels but for ties, and leaves out the last, of "
    "steep lines upward also the first",
    "[oracle][line]"
) {
    int ties = 0;
    int without_first = 0;
    for_lines(200, center, [&](const Pixels& theirs, const OurLine& line) {
        const raster::LineSetup& setup = line.setup;
        const bool upward = setup.steep && setup.last.y < setup.first.y;
        Pixels expected = line.pixels;
        expected.erase(pair_of(setup.last));
        if (upward) {
            expected.erase(pair_of(setup.first));
            ++without_first;
        }
        INFO(
            "from " << setup.first.x << "," << setup.first.y << " to " << setup.last.x << ","
                    << setup.last.y
        );
        Pixels apart;
        std::ranges::set_symmetric_difference(theirs, expected, std::inserter(apart, apart.end()));
        for (const auto& [x, y] : apart) {
            INFO("pixel " << x << "," << y << (theirs.contains({x, y}) ? " theirs" : " ours"));
            REQUIRE(is_tie(setup, x, y));
            ++ties;
        }
    });
    if (tests::mesa() != nullptr) {
        CHECK(ties > 100);
        CHECK(without_first > 100);
    }
}

TEST_CASE(
    "between any positions, where Mesa follows the exact line and we the one between pixel "
    "centers, "
    "they are never more than one pixel apart",
    "[oracle][line]"
) {
    int apart = 0;
    for_lines(200, anywhere, [&](const Pixels& theirs, const OurLine& line) {
        std::map<int, int> across; // ours, by place along the line
        for (const auto& [x, y] : line.pixels) {
            across.insert(along_and_across(line.setup, x, y));
        }
        for (const auto& [x, y] : theirs) {
            const auto [place, theirs_across] = along_and_across(line.setup, x, y);
            const auto found = across.find(place);
            REQUIRE(found != across.end());
            REQUIRE(std::abs(found->second - theirs_across) <= 1);
            apart += found->second != theirs_across ? 1 : 0;
        }
        REQUIRE(theirs.size() + 2 >= line.pixels.size());
    });
    if (tests::mesa() != nullptr) {
        CHECK(apart > 1000);
    }
}
