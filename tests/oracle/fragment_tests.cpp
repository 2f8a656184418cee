// Depth functions, depth writes, culling, scissor and blending, against Mesa's llvmpipe.
//
// Depths that are constant over a triangle are equal to the bit on both sides, so every comparison
// has one right result and images must be identical.
#include "tests/support/catch.hpp"
#include "tests/support/exact_triangle.hpp"
#include "tests/support/mesa.hpp"
#include "tests/support/triangle_soup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

using namespace hs;

namespace {

/// A byte of the channel in all positions, as a float.
float random_byte(tests::Random& random) {
    return static_cast<float>(random.below(256)) / 255.0F;
}

/// Overlapping triangles of one color and one of five depths each.
tests::Soup layered_soup(const PixelRect& image, int triangles, tests::Random& random) {
    constexpr std::array kinds{
        tests::SoupKind::anywhere, tests::SoupKind::pixel_centers, tests::SoupKind::subpixels};
    tests::Soup soup;
    for (int i = 0; i < triangles; ++i) {
        const auto kind = kinds[random.below(kinds.size())];
        const float z = -0.5F + 0.25F * static_cast<float>(random.below(5));
        const glm::vec4 color{
            random_byte(random), random_byte(random), random_byte(random), random_byte(random)};
        for (const glm::dvec2& window : tests::soup_triangle(kind, image, random)) {
            const float w = std::ldexp(1.0F, static_cast<int>(random.below(4)) - 1);
            soup.push_back({tests::clip_at(window, z, w, image), color});
        }
    }
    return soup;
}

scene::Settings small_frame() {
    scene::Settings settings;
    settings.width = 100;
    settings.height = 61;
    settings.background = {0.2F, 0.4F, 0.6F, 0.8F};
    settings.clip_enabled = false;
    settings.depth_clear_choice = 0.5F;
    return settings;
}

int channel(std::uint32_t color, unsigned k) {
    return static_cast<int>(color >> (8 * k) & 0xFFU);
}

struct Differences {
    std::int64_t triangles = 0; ///< pixels that show another triangle
    std::int64_t depths = 0;    ///< pixels whose stored depth is another integer
    int color = 0;              ///< the largest, in bytes
};

Differences differences(
    const scene::Settings& settings, const tests::Drawing& ours, const peer::Image& theirs
) {
    Differences result;
    for (std::size_t i = 0; i < ours.triangle.size(); ++i) {
        result.triangles += ours.triangle[i] == theirs.triangle[i] ? 0 : 1;
        const float depth = ours.target.depth(ours.pixel(i));
        const bool same_depth =
            tests::raw_depth(depth, settings.depth_format) == theirs.depth_raw[i];
        result.depths += same_depth ? 0 : 1;
        for (unsigned k = 0; k < 4; ++k) {
            const int difference =
                std::abs(channel(ours.target.rgba8()[i], k) - theirs.rgba8[4 * i + k]);
            result.color = std::max(result.color, difference);
        }
    }
    return result;
}

Differences differences(
    peer::Context& mesa,
    const scene::Settings& settings,
    const tests::Soup& soup,
    tests::Sides sides = tests::Sides::do_not_clip
) {
    return differences(
        settings,
        tests::drawn(tests::soup_scene(soup, settings)),
        tests::drawn_by(mesa, soup, settings, sides)
    );
}

void check_identical(const Differences& found) {
    CHECK(found.triangles == 0);
    CHECK(found.depths == 0);
    CHECK(found.color == 0);
}

} // namespace

TEST_CASE("every depth function keeps the fragments Mesa keeps", "[oracle][depth]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    tests::Random random(41);
    for (const Named<scene::CompareOp>& op : names<scene::CompareOp>()) {
        for (const Named<scene::DepthFormat>& format : names<scene::DepthFormat>()) {
            for (const bool write : {true, false}) {
                INFO(op.name << ", " << format.name << ", depth write " << write);
                scene::Settings settings = small_frame();
                settings.depth_test_choice = op.value;
                settings.depth_format = format.value;
                settings.depth_write = write;
                const tests::Soup soup = layered_soup(settings.image(), 60, random);
                check_identical(differences(*mesa, settings, soup));
                settings.depth_order = scene::DepthOrder::early;
                check_identical(differences(*mesa, settings, soup));
            }
        }
    }
}

TEST_CASE("without visibility the later triangle covers, as in Mesa", "[oracle]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    tests::Random random(42);
    scene::Settings settings = small_frame();
    settings.visibility = scene::Visibility::none;
    check_identical(differences(*mesa, settings, layered_soup(settings.image(), 60, random)));
}

TEST_CASE("culling removes the triangles Mesa removes", "[oracle][facing]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    tests::Random random(43);
    for (const Named<scene::CullFace>& cull : names<scene::CullFace>()) {
        for (const Named<scene::Winding>& winding : names<scene::Winding>()) {
            INFO("cull " << cull.name << ", front is " << winding.name);
            for (int round = 0; round < 20; ++round) {
                scene::Settings settings = small_frame();
                settings.cull = cull.value;
                settings.front_face = winding.value;
                settings.depth_clear_choice.reset();
                const tests::Soup soup = layered_soup(settings.image(), 60, random);
                check_identical(differences(*mesa, settings, soup));
            }
        }
    }
}

TEST_CASE("the scissor rectangle keeps the pixels Mesa keeps", "[oracle]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    tests::Random random(44);
    for (const PixelRect& scissor :
         {PixelRect{10, 5, 40, 30}, {0, 0, 100, 61}, {99, 60, 100, 61}, {0, 30, 100, 31}}) {
        scene::Settings settings = small_frame();
        settings.scissor = scissor;
        INFO("scissor from " << scissor.x0 << ", " << scissor.y0);
        check_identical(differences(*mesa, settings, layered_soup(settings.image(), 60, random)));
    }
}

/// One layer over the background, many times: no error can pile up.
TEST_CASE("a blended layer differs from Mesa's by at most one level", "[oracle][blend]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    tests::Random random(45);
    int worst = 0;
    for (int round = 0; round < 300; ++round) {
        scene::Settings settings = small_frame();
        settings.width = 16;
        settings.height = 16;
        settings.visibility = scene::Visibility::none;
        settings.blend_enabled = true;
        for (int k = 0; k < 4; ++k) {
            settings.background[k] = random_byte(random);
        }
        const tests::Soup soup = layered_soup(settings.image(), 1, random);
        const Differences found = differences(*mesa, settings, soup);
        REQUIRE(found.triangles == 0);
        worst = std::max(worst, found.color);
    }
    CHECK(worst <= 1);
}

TEST_CASE(
    "a stack of blended layers differs from Mesa's by at most two levels", "[oracle][blend]"
) {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    tests::Random random(46);
    int worst = 0;
    for (int round = 0; round < 60; ++round) {
        scene::Settings settings = small_frame();
        settings.visibility = scene::Visibility::none;
        settings.blend_enabled = true;
        const tests::Soup soup = layered_soup(settings.image(), 24, random);
        const Differences found = differences(*mesa, settings, soup);
        REQUIRE(found.triangles == 0);
        worst = std::max(worst, found.color);
    }
    CHECK(worst <= 2);
}

namespace {

tests::ExactTriangle exact(const tests::Soup& soup, int triangle, const PixelRect& image) {
    const std::size_t t = 3 * static_cast<std::size_t>(triangle);
    return {std::array{soup[t].clip, soup[t + 1].clip, soup[t + 2].clip}, image};
}

/// Whether two triangles are as deep as each other at a pixel, as far as tolerances tell. The
/// background is at depth 1.
bool tie(
    const tests::Soup& soup, const scene::Settings& settings, PixelPos pixel, int ours, int theirs
) {
    double apart = 0.0;
    double allowed = 0.0;
    for (const auto& [triangle, sign] : {std::pair{ours, 1.0}, std::pair{theirs, -1.0}}) {
        if (triangle < 0) {
            apart += sign;
        } else {
            const tests::ExactTriangle plane = exact(soup, triangle, settings.image());
            apart += sign * plane.depth(tests::center(pixel));
            allowed += tests::depth_tolerance(plane, settings);
        }
    }
    return std::fabs(apart) <= allowed;
}

} // namespace

TEST_CASE("penetrating triangles meet where they meet in Mesa", "[oracle][depth]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    tests::Random random(47);
    std::int64_t differing = 0;
    std::int64_t wrong = 0;
    for (int round = 0; round < 100; ++round) {
        scene::Settings settings = small_frame();
        settings.width = 200;
        settings.height = 150;
        settings.depth_format = scene::DepthFormat::unorm24;
        settings.depth_clear_choice.reset();
        tests::Soup soup = layered_soup(settings.image(), 30, random);
        for (tests::Corner& corner : soup) {
            corner.clip.z = random.between(-0.95F, 0.95F) * corner.clip.w;
        }
        const tests::Drawing ours = tests::drawn(tests::soup_scene(soup, settings));
        const peer::Image theirs =
            tests::drawn_by(*mesa, soup, settings, tests::Sides::do_not_clip);
        for (std::size_t i = 0; i < ours.triangle.size(); ++i) {
            if (ours.triangle[i] == theirs.triangle[i]) {
                continue;
            }
            ++differing;
            wrong +=
                tie(soup, settings, ours.pixel(i), ours.triangle[i], theirs.triangle[i]) ? 0 : 1;
        }
    }
    INFO(differing << " of " << 100 * 200 * 150 << " pixels differ");
    CHECK(wrong == 0);
    CHECK(differing < 3000);
}
