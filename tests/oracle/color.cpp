// Interpolated colors, byte by byte, against Mesa's llvmpipe.
//
// Both round numbers that differ by what snapping moves (Mesa interpolates through vertices that
// are not snapped) and by the last bits of a float. A byte may be any rounding of the values within
// that range, and nothing else: on gentle triangles (12 levels per pixel) that is the .024 around a
// half of a flat rule.
#include "tests/support/catch.hpp"
#include "tests/support/exact_triangle.hpp"
#include "tests/support/mesa.hpp"
#include "tests/support/triangle_soup.hpp"

#include <array>
#include <cmath>

using namespace hs;

namespace {

tests::Soup colored_soup(const PixelRect& image, int triangles, tests::Random& random) {
    constexpr std::array kinds{
        tests::SoupKind::anywhere,
        tests::SoupKind::pixel_corners,
        tests::SoupKind::subpixels,
        tests::SoupKind::slivers,
        tests::SoupKind::tiny,
        tests::SoupKind::huge};
    tests::Soup soup;
    for (int i = 0; i < triangles; ++i) {
        const auto kind = kinds[random.below(kinds.size())];
        for (const glm::dvec2& window : tests::soup_triangle(kind, image, random)) {
            const glm::vec4 clip = tests::clip_at(window, 0.0F, random.between(0.2F, 10.0F), image);
            glm::vec4 color{0.0F};
            for (int channel = 0; channel < 4; ++channel) {
                color[channel] = random.between(0.0F, 1.0F);
            }
            soup.push_back({clip, color});
        }
    }
    return soup;
}

scene::Settings settings_for(scene::InterpolationKind interpolation, int round) {
    scene::Settings settings;
    settings.width = round % 2 == 0 ? 256 : 255;
    settings.height = round % 2 == 0 ? 256 : 127;
    settings.clip_enabled = false;
    settings.visibility = scene::Visibility::none;
    settings.interpolation = interpolation;
    return settings;
}

/// The bytes that an honest implementation may store for one channel of one pixel.
struct AllowedBytes {
    int low = 0;
    int high = 0;
    [[nodiscard]] bool contain(int byte) const { return low <= byte && byte <= high; }
};

AllowedBytes allowed_bytes(const tests::Range& value, int image_size) {
    const double slope = 256.0 * (value.high - value.low);
    const double float_error = 8.0 * 0x1p-24 * (1.0 + image_size * slope);
    const auto byte = [](double v) {
        return static_cast<int>(std::lround(255.0 * std::clamp(v, 0.0, 1.0)));
    };
    return {byte(value.low - float_error), byte(value.high + float_error)};
}

struct Tally {
    std::int64_t bytes = 0;
    std::int64_t unequal = 0;
    std::int64_t wrong_ours = 0;
    std::int64_t wrong_theirs = 0;
};

/// Compares every byte with what is allowed for the triangle that wrote it.
void compare(
    const tests::Soup& soup,
    const scene::Settings& settings,
    const tests::Drawing& ours,
    const peer::Image& theirs,
    Tally& tally
) {
    const bool perspective = settings.interpolation == scene::InterpolationKind::perspective;
    for (std::size_t i = 0; i < ours.triangle.size(); ++i) {
        if (ours.triangle[i] < 0) {
            continue;
        }
        const std::size_t first = 3 * static_cast<std::size_t>(ours.triangle[i]);
        const std::array corners{soup[first].clip, soup[first + 1].clip, soup[first + 2].clip};
        const std::uint32_t our_color = ours.target.rgba8()[i];
        for (std::size_t channel = 0; channel < 4; ++channel) {
            const int a = static_cast<int>(our_color >> (8 * channel) & 0xFFU);
            const int b = theirs.rgba8[4 * i + channel];
            ++tally.bytes;
            if (a == b && tally.bytes % 16 != 0) {
                continue; // equal bytes are checked against the exact value now and then
            }
            const auto c = static_cast<int>(channel);
            const tests::Range value =
                tests::ExactTriangle(corners, settings.image())
                    .near_snap(
                        tests::center(ours.pixel(i)),
                        {soup[first].color[c], soup[first + 1].color[c], soup[first + 2].color[c]},
                        perspective
                    );
            const AllowedBytes allowed = allowed_bytes(value, settings.width);
            tally.unequal += a == b ? 0 : 1;
            tally.wrong_ours += allowed.contain(a) ? 0 : 1;
            tally.wrong_theirs += allowed.contain(b) ? 0 : 1;
        }
    }
}

Tally compare_frames(
    peer::Context& mesa,
    scene::InterpolationKind interpolation,
    scene::InterpolationKind our_interpolation,
    int rounds
) {
    Tally tally;
    tests::Random random(17);
    for (int round = 0; round < rounds; ++round) {
        scene::Settings settings = settings_for(interpolation, round);
        const tests::Soup soup = colored_soup(settings.image(), 40, random);
        const peer::Image theirs = tests::drawn_by(mesa, soup, settings, tests::Sides::do_not_clip);
        settings.interpolation = our_interpolation;
        const tests::Drawing ours = tests::drawn(tests::soup_scene(soup, settings));
        const bool same_coverage = ours.triangle == theirs.triangle;
        REQUIRE(same_coverage);
        settings.interpolation = interpolation;
        compare(soup, settings, ours, theirs, tally);
    }
    return tally;
}

} // namespace

TEST_CASE("interpolated colors are Mesa's, up to roundings of the same value", "[oracle][color]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    for (const auto interpolation :
         {scene::InterpolationKind::perspective, scene::InterpolationKind::linear}) {
        const Tally tally = compare_frames(*mesa, interpolation, interpolation, 60);
        INFO(
            name_of(interpolation)
            << ": " << tally.bytes << " bytes, " << tally.unequal << " of them unequal"
        );
        CHECK(tally.wrong_ours == 0);
        CHECK(tally.wrong_theirs == 0);
        CHECK(tally.unequal < tally.bytes / 500);
        CHECK(tally.bytes > 5'000'000);
    }
}

TEST_CASE("Mesa tells linear interpolation from perspective-correct", "[oracle][color]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    const Tally tally = compare_frames(
        *mesa, scene::InterpolationKind::perspective, scene::InterpolationKind::linear, 4
    );
    CHECK(tally.wrong_ours > tally.bytes / 10);
    CHECK(tally.wrong_theirs == 0);
}

TEST_CASE("flat colors are Mesa's, from the last vertex", "[oracle][color]") {
    peer::Context* const mesa = tests::mesa();
    if (mesa == nullptr) {
        return;
    }
    tests::Random random(23);
    for (int round = 0; round < 4; ++round) {
        const scene::Settings settings = settings_for(scene::InterpolationKind::flat, round);
        const tests::Soup soup = colored_soup(settings.image(), 40, random);
        const tests::Drawing ours = tests::drawn(tests::soup_scene(soup, settings));
        const peer::Image theirs =
            tests::drawn_by(*mesa, soup, settings, tests::Sides::do_not_clip);
        std::int64_t differing = 0;
        for (std::size_t i = 0; i < ours.triangle.size(); ++i) {
            for (unsigned channel = 0; channel < 4; ++channel) {
                const bool equal = (ours.target.rgba8()[i] >> (8 * channel) & 0xFFU) ==
                                   theirs.rgba8[4 * i + channel];
                differing += ours.triangle[i] >= 0 && !equal ? 1 : 0;
            }
        }
        CHECK(differing == 0);
    }
}
