// Which texel a pixel shows, against Mesa's llvmpipe: every texel has its own color.
#include "tests/support/catch.hpp"
#include "tests/support/exact_triangle.hpp"
#include "tests/support/mesa.hpp"
#include "tests/support/triangle_soup.hpp"

#include <array>
#include <cmath>

using namespace hs;

namespace {

std::shared_ptr<const scene::Texture> numbered_texture(int width, int height) {
    auto texture = std::make_shared<scene::Texture>();
    texture->width = width;
    texture->height = height;
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            texture->texels.emplace_back(
                static_cast<float>(i) / 255.0F, static_cast<float>(j) / 255.0F, 0.0F, 1.0F
            );
        }
    }
    return texture;
}

tests::Soup textured_soup(const PixelRect& image, int triangles, tests::Random& random) {
    constexpr std::array kinds{
        tests::SoupKind::anywhere, tests::SoupKind::subpixels, tests::SoupKind::huge};
    tests::Soup soup;
    for (int i = 0; i < triangles; ++i) {
        const auto kind = kinds[random.below(kinds.size())];
        for (const glm::dvec2& window : tests::soup_triangle(kind, image, random)) {
            soup.push_back(
                {.clip = tests::clip_at(window, 0.0F, random.between(0.5F, 5.0F), image),
                 .uv = {random.between(-1.5F, 2.5F), random.between(-1.5F, 2.5F)}}
            );
        }
    }
    return soup;
}

/// Whether texel `shown` contains a coordinate of the range, within 10⁻⁴ texel.
bool may_show(int shown, const tests::Range& coordinate, int size) {
    constexpr double near_boundary = 1.0e-4;
    const auto first = std::llround(std::floor(coordinate.low * size - near_boundary));
    const auto last = std::llround(std::floor(coordinate.high * size + near_boundary));
    for (long long texel = first; texel <= last; ++texel) {
        if ((texel % size + size) % size == shown) {
            return true;
        }
    }
    return false;
}

struct Tally {
    std::int64_t pixels = 0;
    std::int64_t unequal = 0;
    std::int64_t wrong = 0;
};

void compare(
    const tests::Soup& soup,
    const scene::Texture& texture,
    const tests::Drawing& ours,
    const peer::Image& theirs,
    Tally& tally
) {
    const PixelRect image{0, 0, ours.target.width(), ours.target.height()};
    for (std::size_t i = 0; i < ours.triangle.size(); ++i) {
        if (ours.triangle[i] < 0) {
            continue;
        }
        ++tally.pixels;
        const std::uint32_t color = ours.target.rgba8()[i];
        const std::array shown{
            static_cast<int>(color & 0xFFU), static_cast<int>(color >> 8U & 0xFFU)};
        const std::array mesa_shown{int{theirs.rgba8[4 * i]}, int{theirs.rgba8[4 * i + 1]}};
        if (shown == mesa_shown && tally.pixels % 16 != 0) {
            continue; // equal texels are checked against the exact coordinate now and then
        }
        tally.unequal += shown == mesa_shown ? 0 : 1;
        const std::size_t t = 3 * static_cast<std::size_t>(ours.triangle[i]);
        const std::array corners{soup[t].clip, soup[t + 1].clip, soup[t + 2].clip};
        const tests::ExactTriangle exact(corners, image);
        for (int axis = 0; axis < 2; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            const int size = axis == 0 ? texture.width : texture.height;
            const tests::Range coordinate = exact.near_snap(
                tests::center(ours.pixel(i)),
                {soup[t].uv[axis], soup[t + 1].uv[axis], soup[t + 2].uv[axis]},
                true
            );
            tally.wrong += may_show(shown[k], coordinate, size) ? 0 : 1;
            tally.wrong += may_show(mesa_shown[k], coordinate, size) ? 0 : 1;
        }
    }
}

} // namespace

TEST_CASE("nearest lookup shows Mesa's texel, up to what snapping moves", "[oracle][texture]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    Tally tally;
    tests::Random random(31);
    for (int round = 0; round < 60; ++round) {
        scene::Settings settings;
        settings.width = round % 2 == 0 ? 256 : 255;
        settings.height = round % 2 == 0 ? 256 : 127;
        settings.clip_enabled = false;
        settings.visibility = scene::Visibility::none;
        const auto texture =
            round % 3 == 0 ? numbered_texture(16, 16) : numbered_texture(13, 7 + round);
        const tests::Soup soup = textured_soup(settings.image(), 20, random);
        const tests::Drawing ours = tests::drawn(tests::soup_scene(soup, settings, texture));
        const peer::Image theirs =
            tests::drawn_by(*mesa, soup, settings, tests::Sides::do_not_clip, texture.get());
        const bool same_coverage = ours.triangle == theirs.triangle;
        REQUIRE(same_coverage);
        compare(soup, *texture, ours, theirs, tally);
    }
    INFO(tally.pixels << " pixels, " << tally.unequal << " of them unequal");
    CHECK(tally.wrong == 0);
    CHECK(tally.unequal < tally.pixels / 500);
    CHECK(tally.pixels > 1'000'000);
}

/// Two triangles that fill the image, with vertices on pixel corners: snapping moves nothing.
TEST_CASE("a full-screen texture shows exactly Mesa's texels", "[oracle][texture]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    scene::Settings settings;
    settings.width = 128;
    settings.height = 64;
    const auto texture = numbered_texture(37, 91);
    const auto corner = [](float x, float y) {
        return tests::Corner{
            .clip = {x, y, 0.0F, 1.0F}, .uv = {1.5F * (x + 1.0F), 0.75F * (1.0F - y)}};
    };
    const tests::Soup soup{
        corner(-1.0F, -1.0F),
        corner(1.0F, -1.0F),
        corner(1.0F, 1.0F),
        corner(-1.0F, -1.0F),
        corner(1.0F, 1.0F),
        corner(-1.0F, 1.0F)};
    const tests::Drawing ours = tests::drawn(tests::soup_scene(soup, settings, texture));
    const peer::Image theirs =
        tests::drawn_by(*mesa, soup, settings, tests::Sides::clip, texture.get());
    std::int64_t differing = 0;
    for (std::size_t i = 0; i < ours.triangle.size(); ++i) {
        const std::uint32_t color = ours.target.rgba8()[i];
        const bool equal = (color & 0xFFU) == theirs.rgba8[4 * i] &&
                           (color >> 8U & 0xFFU) == theirs.rgba8[4 * i + 1];
        differing += equal ? 0 : 1;
    }
    CHECK(differing == 0);
}
